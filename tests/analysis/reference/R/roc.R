# The ROC of ratings. Areas from all pairs of trials; the normal models by a general optimiser (package numDeriv).
roc_results <- function(data, confidence) for (condition in unique(data$condition)) {
  own <- data[data$condition == condition, ]
  own <- own[order(own$rating), ]
  ratings <- nrow(own); n <- c(sum(own$noise), sum(own$signal))
  row("n.noise", condition, n[1], "count"); row("n.signal", condition, n[2], "count")
  from <- function(counts) rev(cumsum(rev(counts)))[-1] / sum(counts)
  keys <- paste0(condition, "|", own$rating[-1])
  rows("roc.fa", keys, from(own$noise)); rows("roc.hit", keys, from(own$signal))
  signal <- rep(own$rating, own$signal); noise <- rep(own$rating, own$noise)
  above <- outer(signal, noise, function(a, b) (a > b) + 0.5 * (a == b))
  area <- mean(above)
  error <- sqrt(var(rowMeans(above)) / n[2] + var(colMeans(above)) / n[1])  # [DeLong 1988]
  reach <- qnorm(0.5 + confidence / 2) * error
  row("auc", condition, area); row("auc.se.delong", condition, error)
  row("auc.lower", condition, area - reach); row("auc.upper", condition, area + reach)
  q1 <- area / (2 - area); q2 <- 2 * area^2 / (1 + area)
  row("auc.se.hanley", condition,
      sqrt((area * (1 - area) + (n[2] - 1) * (q1 - area^2) + (n[1] - 1) * (q2 - area^2)) / prod(n)))
  # Parameters: mean, ln SD (free), the first criterion, the logarithms of the distances to the next ones.
  parts <- function(theta, free) {
    first <- if (free) 3 else 2
    list(mean = theta[1], sd = if (free) exp(theta[2]) else 1,
         criteria = cumsum(c(theta[first], exp(theta[seq_len(ratings - 2) + first]))))
  }
  loglik <- function(theta, free) {
    at <- parts(theta, free)
    p <- c(diff(c(0, pnorm(at$criteria), 1)), diff(c(0, pnorm((at$criteria - at$mean) / at$sd), 1)))
    if (any(p <= 0)) return(-1e10)
    sum(c(own$noise, own$signal) * log(p))
  }
  cuts <- qnorm(pmin(pmax(1 - from(own$noise), 0.01), 0.99))
  found <- list()
  for (free in c(FALSE, TRUE)) {
    start <- c(qnorm(mean(from(own$signal))) - qnorm(mean(from(own$noise))), if (free) 0, cuts[1],
               log(pmax(diff(cuts), 0.05)))
    f <- function(theta) loglik(theta, free)
    theta <- largest(f, start); covariance <- curvature(f, theta); at <- parts(theta, free)
    model <- if (free) "uv" else "ev"
    put <- function(quantity, value, known = "optimum") row(paste0(model, ".", quantity), condition, value, known)
    put("mu", at$mean); put("mu.se", sqrt(covariance[1, 1]), "curvature")
    if (free) {
      put("sigma", at$sd); put("sigma.se", at$sd * sqrt(covariance[2, 2]), "curvature")
      sensitivity <- at$mean / sqrt((1 + at$sd^2) / 2)
      put("da", sensitivity); put("az", pnorm(sensitivity / sqrt(2)))
    }
    rows(paste0(model, ".criterion"), keys, at$criteria, "optimum")
    put("loglik", f(theta)); found[[model]] <- f(theta)
  }
  ratio <- 2 * (found$uv - found$ev)
  row("lr.equal.variance", condition, ratio, "optimum")
  row("lr.equal.variance.p", condition, pchisq(ratio, 1, lower.tail = FALSE), "optimum")
  saturated <- sum(sapply(list(own$noise, own$signal), function(k) sum(ifelse(k > 0, k * log(k / sum(k)), 0))))
  row("uv.deviance", condition, 2 * (saturated - found$uv), "optimum")
  row("uv.df", condition, 2 * (ratings - 1) - (ratings + 1), "count")
}
