# Cumulative link (mixed) models. Without random intercepts: clm of package ordinal, and polr of MASS. With them: the maximum of the
# Laplace approximation as it is defined, found here by a general optimiser and Newton's steps on numerical derivatives of a dense
# matrix of all intercepts; clmm of ordinal, whose optimiser stops earlier, has to agree, and its numbers are written as well ("clmm.").
source("results.R")
suppressPackageStartupMessages({ library(ordinal); library(MASS) })

log_laplace <- function(x, y, X, Z, sigma_of) {
  J <- max(y); theta <- c(-Inf, x[seq_len(J - 1)], Inf); beta <- x[J - 1 + seq_len(ncol(X))]; sigma <- x[-seq_len(J - 1 + ncol(X))]
  if (any(diff(theta) <= 0)) return(-1e10)
  fixed <- drop(X %*% beta); L <- sweep(Z, 2, sigma[sigma_of], "*")
  joint <- function(u) {
    eta <- fixed + drop(L %*% u); a <- theta[y + 1] - eta; b <- theta[y] - eta
    p <- ifelse(a > 0 & b > 0, plogis(-b) - plogis(-a), plogis(a) - plogis(b))
    s <- (dlogis(b) - dlogis(a)) / p  # by eta
    d <- function(v) ifelse(is.finite(v), dlogis(v) * (1 - 2 * plogis(v)), 0)
    w <- s^2 - (d(a) - d(b)) / p
    list(value = sum(log(p)) - sum(u^2) / 2, slope = drop(crossprod(L, s)) - u, information = crossprod(L, w * L) + diag(length(u)))
  }
  u <- numeric(ncol(Z))
  for (step in 1:100) {
    at <- joint(u); move <- solve(at$information, at$slope)
    while (joint(u + move)$value < at$value - 1e-10) move <- move / 2
    u <- u + move
    if (max(abs(move)) < 1e-12) break
  }
  at <- joint(u)
  at$value - as.numeric(determinant(at$information)$modulus) / 2
}

maximum <- function(data, X, random, start) {
  y <- as.integer(data$category)
  indicators <- lapply(random, function(name) model.matrix(~ 0 + factor(data[[name]])))
  Z <- do.call(cbind, indicators); sigma_of <- rep(seq_along(random), sapply(indicators, ncol))
  f <- function(x) log_laplace(x, y, X, Z, sigma_of)
  x <- optim(start, function(x) -f(x), method = "BFGS", control = list(reltol = 1e-14, maxit = 500))$par
  for (i in 1:4) x <- x - solve(numDeriv::hessian(f, x), numDeriv::grad(f, x))
  stopifnot(max(abs(numDeriv::grad(f, x))) < 1e-5)
  list(x = x, value = f(x), vcov = solve(-numDeriv::hessian(f, x)))
}

parameter_rows <- function(name, J, p, x, se, loglik) {
  rows(paste0(name, ".threshold"), seq_len(J - 1), x[seq_len(J - 1)]); rows(paste0(name, ".threshold.se"), seq_len(J - 1), se[seq_len(J - 1)])
  rows(paste0(name, ".beta"), seq_len(p), x[J - 1 + seq_len(p)]); rows(paste0(name, ".se"), seq_len(p), se[J - 1 + seq_len(p)])
  row(paste0(name, ".loglik"), "", loglik)
}

# Fixed effects alone.
fixed_case <- function(name, data, effects) {
  X <- as.matrix(data[effects]); J <- nlevels(data$category)
  fit <- clm(reformulate(effects, "category"), data = data, control = clm.control(gradTol = 1e-12, maxIter = 200))
  s <- coef(summary(fit)); stopifnot(nrow(s) == J - 1 + ncol(X))
  parameter_rows(name, J, ncol(X), s[, 1], s[, 2], as.numeric(logLik(fit)))
  rows(paste0(name, ".z"), effects, s[J:nrow(s), 3]); rows(paste0(name, ".p"), effects, s[J:nrow(s), 4])
  other <- polr(reformulate(effects, "category"), data = data, Hess = TRUE, control = list(reltol = 1e-14))
  stopifnot(max(abs(c(other$zeta, coef(other)) - s[, 1])) < 1e-4, abs(as.numeric(logLik(other)) - as.numeric(logLik(fit))) < 1e-7)
}

# With random intercepts; `effects` names columns of numbers in the data.
mixed_case <- function(name, data, effects, random) {
  X <- as.matrix(data[effects]); J <- nlevels(data$category); p <- ncol(X)
  terms <- c(effects, paste0("(1 | ", random, ")")); for (r in random) data[[r]] <- factor(data[[r]])
  formula <- reformulate(if (p) terms else c("1", terms), "category")
  # Modes to a gradient of 1e-9, with a warning wherever rounding prevents it; the default of 1e-4 leaves errors of up to 2e-4 in the
  # log likelihood. The numerical Hessian is that of a second fit with the default, which has less noise.
  fit <- suppressWarnings(clmm(formula, data = data, control = clmm.control(gradTol = 1e-9, maxIter = 200)))
  fit_of_errors <- clmm(formula, data = data, Hess = TRUE)
  theirs <- c(fit$alpha, fit$beta); sigma <- sapply(random, function(r) attr(VarCorr(fit)[[r]], "stddev")[[1]])
  own <- maximum(data, X, random, unname(c(theirs, sigma)))
  k <- seq_along(theirs); se <- sqrt(diag(own$vcov)); sigma_own <- abs(own$x[-k])
  their_se <- sqrt(diag(vcov(fit_of_errors)))[k]
  parameter_rows(name, J, p, own$x, se, own$value); rows(paste0(name, ".sigma"), random, sigma_own)
  parameter_rows(paste0("clmm.", name), J, p, theirs, their_se, as.numeric(logLik(fit))); rows(paste0("clmm.", name, ".sigma"), random, sigma)
  cat(name, ": largest difference to clmm", max(abs(theirs - own$x[k])), max(abs(sigma - sigma_own)), max(abs(their_se - se[k])), as.numeric(logLik(fit)) - own$value, "\n")
  stopifnot(max(abs(c(theirs, sigma) - c(own$x[k], sigma_own))) < 1e-4, abs(as.numeric(logLik(fit)) - own$value) < 1e-7)
  own$value
}

# The bitterness of wines of ordinal: nine judges, five categories.
w <- data.frame(category = factor(wine$rating), participant = as.integer(wine$judge), item = as.integer(wine$bottle),
                warm = as.numeric(wine$temp == "warm"), contact = as.numeric(wine$contact == "yes"))
write_data(w, "wine.csv")
fixed_case("wine", w, c("warm", "contact"))
full <- mixed_case("wine.judges", w, c("warm", "contact"), "participant")
reduced <- mixed_case("wine.judges.warm", w, "warm", "participant")
row("wine.judges", "lr", 2 * (full - reduced))

# Ratings drawn from the model: crossed participants and items, three conditions and a covariate.
drawn <- function(seed, participants, items, theta, beta, sigma, missing) {
  set.seed(seed)
  d <- expand.grid(condition = 0:2, item = seq_len(items), participant = seq_len(participants))
  u <- rnorm(participants, 0, sigma[1]); v <- rnorm(items, 0, sigma[2]); roughness <- round(rnorm(items, 5, 20), 2)
  d$second <- as.numeric(d$condition == 1); d$third <- as.numeric(d$condition == 2); d$roughness <- roughness[d$item]
  eta <- drop(as.matrix(d[c("second", "third", "roughness")]) %*% beta) + u[d$participant] + v[d$item]
  d$category <- factor(findInterval(eta + rlogis(nrow(d)), theta) + 1)
  d <- d[runif(nrow(d)) >= missing, c("category", "participant", "item", "second", "third", "roughness")]
  stopifnot(nlevels(d$category) == length(theta) + 1, all(table(d$category) > 0))
  d
}
a <- drawn(31, 14, 8, c(-2, -0.8, 0.4, 1.3, 2.6, 4), c(0.7, -0.5, 0.02), c(1.1, 0.6), 0.1)
write_data(a, "crossed_ratings.csv")
fixed_case("ratings", a, c("second", "third", "roughness"))
full <- mixed_case("ratings.crossed", a, c("second", "third", "roughness"), c("participant", "item"))
reduced <- mixed_case("ratings.crossed.roughness", a, "roughness", c("participant", "item"))
row("ratings.crossed", "lr", 2 * (full - reduced))
invisible(mixed_case("ratings.items", a, c("second", "third"), "item"))
invisible(mixed_case("ratings.empty", a, character(), c("participant", "item")))

# Two categories: logistic regression with crossed intercepts, of few responses.
b <- drawn(32, 9, 6, 0.5, c(1, 0, 0), c(0.9, 0.8), 0)
write_data(b, "crossed_binary.csv")
invisible(mixed_case("binary.crossed", b, c("second", "third"), c("participant", "item")))
write_results("cumulative_link_expected.csv")
