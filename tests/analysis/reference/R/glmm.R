# Participants and items as crossed random intercepts. With the logit by glmer of lme4. Its Laplace approximation has the expected
# information where the definition has the observed one, which is the same for the logit alone: with the probit the maximum is found
# here, and glmer's has to lie within 1 %.
suppressPackageStartupMessages(library(lme4))
source("../R/differences.R")
tolerances$fit <- c(1e-5, 1e-7)

log_laplace <- function(parameters, data, design, intercepts, sigma_of) {
  fixed <- drop(design %*% parameters[seq_len(ncol(design))])
  loading <- sweep(intercepts, 2, parameters[-seq_len(ncol(design))][sigma_of], "*")
  hits <- data$correct; misses <- data$trials - data$correct
  joint <- function(u) {
    eta <- fixed + drop(loading %*% u)
    above <- exp(dnorm(eta, log = TRUE) - pnorm(eta, log.p = TRUE)); below <- exp(dnorm(eta, log = TRUE) - pnorm(-eta, log.p = TRUE))
    list(value = sum(hits * pnorm(eta, log.p = TRUE) + misses * pnorm(-eta, log.p = TRUE)) - sum(u^2) / 2,
         slope = drop(crossprod(loading, hits * above - misses * below)) - u,
         information = crossprod(loading, (hits * above * (above + eta) + misses * below * (below - eta)) * loading) + diag(length(u)))
  }
  u <- numeric(ncol(intercepts))
  for (step in 1:100) {
    at <- joint(u); move <- solve(at$information, at$slope)
    while (joint(u + move)$value < at$value - 1e-10) move <- move / 2
    u <- u + move
    if (max(abs(move)) < 1e-12) break
  }
  at <- joint(u)
  sum(lchoose(data$trials, hits)) + at$value - as.numeric(determinant(at$information)$modulus) / 2
}

# Coefficients with their errors, standard deviations, log-likelihood.
by_definition <- function(data, design, random, start) {
  indicators <- lapply(random, function(name) model.matrix(~ 0 + factor(data[[name]])))
  sigma_of <- rep(seq_along(random), sapply(indicators, ncol))
  f <- function(x) log_laplace(x, data, design, do.call(cbind, indicators), sigma_of)
  x <- optim(start, function(x) -f(x), method = "BFGS", control = list(reltol = 1e-14, maxit = 500))$par
  for (i in 1:5) { d <- differences(f, x, 1e-3); x <- x - solve(d$hessian, d$gradient) }
  effects <- seq_len(ncol(design))
  list(beta = x[effects], se = sqrt(diag(solve(-differences(f, x, 1e-3)$hessian)))[effects], sigma = x[-effects], loglik = f(x))
}

by_glmer <- function(data, factors, random, link) {
  right <- paste(c("1", factors, paste0("(1 | ", random, ")")), collapse = " + ")
  fit <- glmer(as.formula(paste("cbind(correct, trials - correct) ~", right)), data, binomial(link),
               control = glmerControl("bobyqa", tolPwrss = 1e-12, optCtrl = list(rhoend = 1e-9, maxfun = 1e5),
                                      check.conv.grad = "ignore", check.conv.hess = "ignore"))
  stopifnot(!isSingular(fit))
  list(beta = unname(fixef(fit)), se = unname(sqrt(diag(as.matrix(vcov(fit))))),
       sigma = sapply(random, function(name) attr(VarCorr(fit)[[name]], "stddev")[[1]], USE.NAMES = FALSE),
       loglik = as.numeric(logLik(fit)), design = model.matrix(fit))
}

maximum_of <- function(data, factors, random, link) {
  lme4s <- by_glmer(data, factors, random, link)
  if (link == "logit") return(lme4s)
  own <- by_definition(data, lme4s$design, random, c(lme4s$beta, lme4s$sigma))
  for (part in names(own)) stopifnot(abs(own[[part]] - lme4s[[part]]) <= 0.01 * abs(own[[part]]))
  own
}

glmm_results <- function(data, link, fixed = character(), random = c("subject", "item"), chance = 0.5, covariates = character()) {
  for (name in c("subject", random, fixed)) data[[name]] <- factor(data[[name]], unique(data[[name]]))
  effects <- c(fixed, covariates)
  # In units of their SD: the differences by which lme4 finds errors are too wide for coefficients that are not of the order of 1.
  deviations <- vapply(covariates, function(name) sd(data[[name]]), 0)
  for (name in covariates) data[[name]] <- data[[name]] / deviations[[name]]
  fit <- maximum_of(data, effects, random, link)
  of_covariates <- length(fit$beta) - length(covariates) + seq_along(covariates)
  fit$beta[of_covariates] <- fit$beta[of_covariates] / deviations; fit$se[of_covariates] <- fit$se[of_covariates] / deviations
  row("n.subjects", "", nlevels(data$subject), "count")
  if ("item" %in% random) row("n.items", "", nlevels(data$item), "count")
  row("glmm.status", "", "ok")
  keys <- c("intercept", unlist(lapply(fixed, function(name) paste0(name, "|", levels(data[[name]])[-1]))), covariates)
  z <- (fit$beta - c(make.link(link)$linkfun(chance), rep(0, length(fit$beta) - 1))) / fit$se
  rows("glmm.beta", keys, fit$beta, "fit"); rows("glmm.se", keys, fit$se, "curvature")
  rows("glmm.z", keys, z, "curvature"); rows("glmm.p", keys, 2 * pnorm(-abs(z)), "curvature")
  row("glmm.proportion", "", make.link(link)$linkinv(fit$beta[1]), "fit")
  rows("glmm.sigma", random, fit$sigma, "fit"); row("glmm.loglik", "", fit$loglik, "fit")
  for (name in effects) {
    ratio <- 2 * (fit$loglik - maximum_of(data, setdiff(effects, name), random, link)$loglik)
    df <- if (name %in% fixed) nlevels(data[[name]]) - 1 else 1
    row("glmm.lr", name, ratio, "fit"); row("glmm.lr.df", name, df, "count")
    row("glmm.lr.p", name, pchisq(ratio, df, lower.tail = FALSE), "curvature")
  }
}
# Choices of the first of two surfaces, one per row, that follow the differences of the forces (N) and speeds (m/s) of exploration.
drawn_choices <- function(seed, participants, trials, effects, sigma) {
  set.seed(seed)
  data <- expand.grid(trial = seq_len(trials), subject = sprintf("P%02d", seq_len(participants)))
  data$force_difference_N <- round(rnorm(nrow(data), 0, 0.3), 3); data$speed_difference_m_per_s <- round(rnorm(nrow(data), 0, 0.02), 4)
  eta <- rnorm(participants, 0, sigma)[as.integer(data$subject)] + effects[1] * data$force_difference_N +
    effects[2] * data$speed_difference_m_per_s
  data.frame(data[c("subject", "force_difference_N", "speed_difference_m_per_s")], correct = rbinom(nrow(data), 1, plogis(eta)), trials = 1)
}
# Responses drawn from the model with the logit.
drawn_responses <- function(seed, participants, items, trials, effects, sigma) {
  set.seed(seed)
  data <- expand.grid(condition = names(effects), item = paste0("T", seq_len(items)), subject = sprintf("P%02d", seq_len(participants)))
  u <- rnorm(participants, 0, sigma[1]); v <- rnorm(items, 0, sigma[2])
  eta <- effects[as.character(data$condition)] + u[as.integer(data$subject)] + v[as.integer(data$item)]
  data.frame(subject = data$subject, item = data$item, condition = data$condition,
             correct = rbinom(nrow(data), trials, plogis(eta)), trials = trials)
}
