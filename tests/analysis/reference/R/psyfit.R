# Psychometric functions: a general optimiser from many starts within the bounds, curvatures by differences, profiles by root finding.
shapes <- list(logistic = list(F = function(x, a, b) plogis(x, a, 1 / b), Q = function(p, a, b) qlogis(p, a, 1 / b)),
               normal = list(F = function(x, a, b) pnorm(x, a, 1 / b), Q = function(p, a, b) qnorm(p, a, 1 / b)),
               gumbel = list(F = function(x, a, b) 1 - exp(-10^(b * (x - a))), Q = function(p, a, b) a + log10(-log(1 - p)) / b),
               weibull = list(F = function(x, a, b) pweibull(x, b, a), Q = function(p, a, b) qweibull(p, b, a)))

judgement <- function(d, gamma, lambda) {
  if (!nrow(d)) return("no_data")
  if (all(d$k == d$n)) return("all_correct")
  if (all(d$k == 0)) return("all_wrong")
  share <- tapply(d$k, d$x, sum) / tapply(d$n, d$x, sum)
  if (length(share) < 2) return("one_level")
  between <- sum(share > 0 & share < 1)
  if (identical(gamma, 0) && identical(lambda, 0) && between < 2 && all(diff(share) >= 0)) return(if (between) "quasi_separated" else "separated")
  "ok"
}
steepest <- function(d, shape) {
  x <- sort(unique(if (shape == "weibull") log(d$x[d$x > 0]) else d$x)); rise <- shapes[[shape]]$Q
  width <- if (shape == "weibull") log(rise(.99, 1, 1)) - log(rise(.01, 1, 1)) else rise(.99, 0, 1) - rise(.01, 0, 1)
  width / min(diff(x))
}

# Free parameters in the order alpha, log beta, gamma, lambda; `fixed` holds those that are not.
problem <- function(d, o) {
  free <- c(TRUE, TRUE, identical(o$gamma, "free"), identical(o$lambda, "free")); top <- log(steepest(d, o$shape))
  low <- c(if (o$shape == "weibull") 1e-9 else -1e3, top - 12, 0, 0)[free]; high <- c(1e3, top, .5, o$lambda_max)[free]
  whole <- function(v) { all <- c(NA, NA, if (free[3]) NA else o$gamma, if (free[4]) NA else o$lambda); all[free] <- v; all }
  f <- function(v) {
    w <- whole(v); p <- w[3] + (1 - w[3] - w[4]) * shapes[[o$shape]]$F(d$x, w[1], exp(w[2]))
    sum(dbinom(d$k, d$n, pmin(pmax(p, 0), 1), log = TRUE))
  }
  list(f = function(v) { value <- f(v); if (is.finite(value)) value else -1e8 }, free = free, low = low, high = high, whole = whole, top = top)
}
climb <- function(f, start, low, high) {
  found <- optim(start, function(v) -f(pmin(pmax(v, low), high)) + 1e3 * sum(pmax(low - v, 0, v - high)), control = list(reltol = 1e-15, maxit = 4000))
  for (i in 1:3) found <- optim(found$par, function(v) -f(pmin(pmax(v, low), high)) + 1e3 * sum(pmax(low - v, 0, v - high)), control = list(reltol = 1e-16, maxit = 4000))
  list(par = pmin(pmax(found$par, low), high), value = f(pmin(pmax(found$par, low), high)))
}
# A line is climbed by optimize; more dimensions end with Newton's steps on differences, away from the bounds.
polish <- function(f, x, low, high) for (i in 1:8) {
  h <- 1e-4; inner <- x - 2.1 * h > low & x + 2.1 * h < high
  if (!any(inner)) return(x)
  g <- function(v) f(replace(x, inner, v)); d <- differences(g, x[inner], h); step <- solve(d$hessian, d$gradient)
  x[inner] <- x[inner] - step
  if (max(abs(step)) < 1e-10 || i == 8) return(x)
}
likeliest <- function(d, o) {
  p <- problem(d, o); levels <- if (o$shape == "weibull") exp(seq(min(log(d$x[d$x > 0])), max(log(d$x)), length.out = 5)) else seq(min(d$x), max(d$x), length.out = 5)
  best <- NULL
  for (a in levels) for (b in p$top - c(.3, 1.2, 2.5)) {
    start <- c(a, b, if (p$free[3]) .08, if (p$free[4]) o$lambda_max / 3); found <- climb(p$f, start, p$low, p$high)
    if (is.null(best) || found$value > best$value) best <- found
  }
  v <- best$par; v[v - p$low < 1e-4] <- p$low[v - p$low < 1e-4]; v[p$high - v < 1e-4] <- p$high[p$high - v < 1e-4]
  v <- polish(p$f, v, p$low, p$high)
  c(p, list(par = v, value = p$f(v), inner = v > p$low & v < p$high, w = p$whole(v)))
}
threshold_at <- function(w, o) shapes[[o$shape]]$Q((o$pt - w[3]) / (1 - w[3] - w[4]), w[1], exp(w[2]))

psyfit_results <- function(data, o, confidence = .95, resamples = NULL) {
  fits <- list()
  for (key in unique(data$condition)) {
    d <- data[data$condition == key & data$n > 0, ]; status <- judgement(d, o$gamma, o$lambda); row("status", key, status)
    share <- d$k / d$n
    if (status == "separated") { row("threshold.bracket.lower", key, max(d$x[share == 0])); row("threshold.bracket.upper", key, min(d$x[share == 1])) }
    if (status == "quasi_separated") for (end in c("lower", "upper")) row(paste0("threshold.bracket.", end), key, d$x[share > 0 & share < 1])
    if (status != "ok") next
    m <- likeliest(d, o); fits[[key]] <- m; w <- m$w; S <- shapes[[o$shape]]
    row("fit.alpha", key, w[1], "optimum"); row("fit.beta", key, exp(w[2]), "optimum"); row("fit.gamma", key, w[3], "optimum"); row("fit.lambda", key, w[4], "optimum")
    inner <- rep(TRUE, 4); inner[m$free] <- m$inner; row("bound.lambda", key, !inner[4]); row("bound.beta", key, !inner[2]); row("loglik", key, m$value, "optimum")
    fitted <- function(x) w[3] + (1 - w[3] - w[4]) * S$F(x, w[1], exp(w[2])); p <- fitted(d$x)
    dev <- 2 * (sum(dbinom(d$k, d$n, share, log = TRUE)) - m$value); df <- nrow(d) - sum(m$inner)
    row("deviance", key, dev, "optimum"); row("deviance.df", key, df, "count"); row("pearson", key, sum((d$k - d$n * p)^2 / (d$n * p * (1 - p))), "optimum"); row("deviance.p.chisq", key, pchisq(dev, df, lower.tail = FALSE), "optimum")
    row("threshold", key, threshold_at(w, o), "optimum")
    if (!inner[2]) next
    some <- m$par[m$inner]; at <- function(v) replace(m$par, m$inner, v)
    v <- solve(-differences(function(v) m$f(at(v)), some, 1e-3)$hessian)
    row("se.alpha", key, sqrt(v[1, 1]), "curvature"); row("se.beta", key, exp(w[2]) * sqrt(v[2, 2]), "curvature")
    slope <- differences(function(v) threshold_at(m$whole(at(v)), o), some, 1e-3)$gradient; se <- sqrt(drop(t(slope) %*% v %*% slope)); z <- qnorm(0.5 + confidence / 2)
    row("threshold.se", key, se, "curvature"); row("threshold.delta.lower", key, threshold_at(w, o) - z * se, "curvature"); row("threshold.delta.upper", key, threshold_at(w, o) + z * se, "curvature")
    h <- 1e-5; t0 <- threshold_at(w, o); row("slope.at.threshold", key, (fitted(t0 + h) - fitted(t0 - h)) / (2 * h), "optimum")
    if (w[3] == 0 && o$shape %in% c("logistic", "normal")) row("jnd", key, diff(S$Q(c(.25, .75), w[1], exp(w[2]))) / 2, "optimum")
    profile <- function(a) {
      if (length(m$par) == 2) return(optimize(function(b) m$f(c(a, b)), c(m$par[2] - 3, m$high[2]), maximum = TRUE, tol = 1e-10)$objective)
      climb(function(v) m$f(c(a, v)), m$par[-1] + .01 * (m$low[-1] + m$high[-1] - 2 * m$par[-1]) / (1 + m$high[-1] - m$low[-1]), m$low[-1], m$high[-1])$value
    }
    lost <- function(a) m$value - profile(a) - qchisq(confidence, 1) / 2
    far <- function(side) { step <- sqrt(v[1, 1]); while (lost(w[1] + side * step) < 0) step <- 1.3 * step; w[1] + side * step }
    row("alpha.profile.lower", key, uniroot(lost, c(far(-1), w[1]), tol = 1e-9)$root, "curvature"); row("alpha.profile.upper", key, uniroot(lost, c(w[1], far(1)), tol = 1e-9)$root, "curvature")
  }
  if (length(fits) == 2 && is.numeric(o$gamma) && is.numeric(o$lambda)) {
    both <- likeliest(data[data$condition %in% names(fits) & data$n > 0, ], o); ratio <- 2 * (fits[[1]]$value + fits[[2]]$value - both$value); key <- paste(names(fits), collapse = "|")
    row("lr.same.function", key, ratio, "optimum"); row("lr.same.function.p", key, exp(-ratio / 2), "optimum")
  }
  if (!is.null(resamples)) {
    key <- data$condition[1]; d <- data[data$condition == key, ]; at_top <- 0
    found <- apply(resamples, 1, function(k) {
      d$k <- k; if (judgement(d, o$gamma, o$lambda) != "ok") return(NA)
      m <- likeliest(d, o); at_top <<- at_top + (m$high[2] == m$par[2]); threshold_at(m$w, o)
    })
    row("boot.slope.at.bound", key, at_top, "count"); row("boot.valid", key, sum(!is.na(found)), "count"); rows("boot.threshold", 1:5, found[1:5], "optimum")
    low <- (1 - confidence) / 2; ends <- quantile(found, c(low, 1 - low), na.rm = TRUE); row("boot.perc.lower", key, ends[[1]], "optimum"); row("boot.perc.upper", key, ends[[2]], "optimum"); row("boot.se", key, sd(found, na.rm = TRUE), "optimum")
  }
}
