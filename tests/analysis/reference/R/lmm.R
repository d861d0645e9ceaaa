# Linear mixed models with a random intercept per participant. Estimates by lmer of lme4, compared with lme of nlme; the standard
# errors, Satterthwaite's degrees of freedom and the F tests by their definitions, from dense matrices and numerical derivatives
# of the criterion over (sigma of the participants, sigma of the residuals) by numDeriv, as lmerTest does.
suppressPackageStartupMessages({library(lme4); library(nlme)})
tolerances$fit <- c(1e-6, 1e-8); tolerances$degrees <- c(1e-5, 1e-8)

criterion <- function(sigma, y, X, Z) {
  V <- sigma[1]^2 * tcrossprod(Z) + sigma[2]^2 * diag(length(y)); W <- solve(V); A <- crossprod(X, W %*% X)
  beta <- solve(A, crossprod(X, W %*% y)); rest <- y - X %*% beta
  log_det <- function(M) as.numeric(determinant(M)$modulus)
  list(value = (length(y) - ncol(X)) * log(2 * pi) + log_det(V) + log_det(A) + sum(rest * (W %*% rest)), beta = drop(beta), C = solve(A))
}
# The minimum of the criterion, from lmer's.
sharpened <- function(start, y, X, Z) {
  f <- function(sigma) criterion(sigma, y, X, Z)$value
  for (step in 1:4) start <- start - drop(solve(numDeriv::hessian(f, start), numDeriv::grad(f, start)))
  start
}

lmm_results <- function(data, fixed = character(), covariates = character(), scale = "linear", confidence = 0.95) {
  complete <- data[complete.cases(data[, c("y", fixed, covariates)]), ]
  row("n.left_out", "", nrow(data) - nrow(complete), "count"); data <- complete
  for (name in c("subject", fixed)) data[[name]] <- factor(data[[name]], unique(data[[name]]))
  if (scale == "log") data$y <- log(data$y)
  row("n.subjects", "", nlevels(data$subject), "count"); row("n.rows", "", nrow(data), "count"); row("lmm.status", "", "ok")
  terms <- paste(c("1", fixed, covariates), collapse = " + ")
  fit <- lmer(as.formula(paste("y ~", terms, "+ (1 | subject)")), data, control = lmerControl(optCtrl = list(xtol_abs = 1e-12, ftol_abs = 1e-14)))
  stopifnot(!isSingular(fit))
  other <- lme(as.formula(paste("y ~", terms)), data, random = ~ 1 | subject)
  stopifnot(max(abs(fixef(fit) - fixef(other))) < 1e-4, abs(logLik(fit) - logLik(other)) < 1e-6)
  X <- model.matrix(fit); Z <- model.matrix(~ 0 + subject, data); y <- data$y
  lme4s <- c(attr(VarCorr(fit)$subject, "stddev")[[1]], sigma(fit)); best <- sharpened(lme4s, y, X, Z); stopifnot(max(abs(best / lme4s - 1)) < 1e-3)
  at <- criterion(best, y, X, Z); stopifnot(at$value <= -2 * as.numeric(logLik(fit)) + 1e-7, abs(at$value + 2 * as.numeric(logLik(fit))) < 1e-4)
  information <- solve(numDeriv::hessian(function(sigma) criterion(sigma, y, X, Z)$value, best))
  degrees <- function(l) {
    variance <- function(sigma) drop(l %*% criterion(sigma, y, X, Z)$C %*% l)
    g <- numDeriv::grad(variance, best); 2 * variance(best)^2 / drop(g %*% (2 * information) %*% g)
  }
  columns <- attr(X, "assign"); keys <- c("intercept", unlist(lapply(fixed, function(name) paste0(name, "|", levels(data[[name]])[-1]))), covariates)
  se <- sqrt(diag(at$C)); df <- sapply(seq_along(keys), function(i) degrees(diag(length(keys))[i, ])); limit <- qt(0.5 + confidence / 2, df)
  rows("lmm.beta", keys, at$beta, "fit"); rows("lmm.se", keys, se, "fit"); rows("lmm.t", keys, at$beta / se, "fit"); rows("lmm.df", keys, df, "degrees")
  rows("lmm.p", keys, 2 * pt(-abs(at$beta / se), df), "degrees")
  if (scale == "log") rows("lmm.ratio", keys, exp(at$beta), "fit")
  for (i in seq_along(fixed)) {
    own <- which(columns == i); axes <- eigen(at$C[own, own, drop = FALSE])
    l <- matrix(0, length(own), length(keys)); l[, own] <- t(axes$vectors)
    t2 <- drop(l %*% at$beta)^2 / axes$values; nu <- apply(l, 1, degrees); expected <- sum(nu / (nu - 2))
    df2 <- if (max(nu) - min(nu) < 1e-4) mean(nu) else if (any(nu <= 2)) 2 else 2 * expected / (expected - length(own))
    row("lmm.F", fixed[i], mean(t2), "fit"); row("lmm.F.df1", fixed[i], length(own), "count"); row("lmm.F.df2", fixed[i], df2, "degrees")
    row("lmm.F.p", fixed[i], pf(mean(t2), length(own), df2, lower.tail = FALSE), "degrees")
  }
  rows("lmm.variance", c("subject", "residual"), best^2, "fit"); row("lmm.icc", "", best[1]^2 / sum(best^2), "fit"); row("lmm.loglik", "", -at$value / 2, "fit")
}
