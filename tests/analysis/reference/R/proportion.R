# One count of hits per row: id, k, n, p0, conf.
proportion_results <- function(data) {
  with_trials <- data[data$n > 0, ]
  for (i in seq_len(nrow(data))) {
    id <- data$id[i]; k <- data$k[i]; n <- data$n[i]; p0 <- data$p0[i]; confidence <- data$conf[i]
    row("status", id, if (n == 0) "no_data" else "ok")
    if (n == 0) next
    row("phat", id, k / n)
    ends <- function(name, interval, known = "formula") { row(paste0(name, ".lower"), id, interval[1], known); row(paste0(name, ".upper"), id, interval[2], known) }
    ends("wilson", wilson(k, n, confidence))
    ends("cp", clopper_pearson(k, n, confidence), "tail")
    error <- (1 - confidence) / 2
    ends("jeffreys", c(if (k == 0) 0 else qbeta(error, k + .5, n - k + .5), if (k == n) 1 else qbeta(1 - error, k + .5, n - k + .5)), "tail")
    z2 <- qnorm(1 - error)^2; p <- (k + z2 / 2) / (n + z2); half <- sqrt(z2 * p * (1 - p) / (n + z2))
    ends("agresticoull", c(max(0, p - half), min(1, p + half)))
    probability <- dbinom(0:n, n, p0); of <- 0:n
    row("p.greater", id, binom.test(k, n, p0, "greater")$p.value, "tail")
    row("p.less", id, binom.test(k, n, p0, "less")$p.value, "tail")
    row("p.two", id, min(1, sum(probability[probability <= probability[k + 1] * (1 + 1e-7)])), "tail")
    greater <- sum(probability[of > k]) + probability[k + 1] / 2
    less <- sum(probability[of < k]) + probability[k + 1] / 2
    row("midp.greater", id, greater, "tail")
    row("midp.two", id, min(1, 2 * greater, 2 * less), "tail")
    row("cohen.h", id, 2 * (asin(sqrt(k / n)) - asin(sqrt(p0))))
  }
  p <- mapply(function(k, n, p0) binom.test(k, n, p0)$p.value, with_trials$k, with_trials$n, with_trials$p0)
  rows("p.two.holm", with_trials$id, p.adjust(p, "holm"), "tail")
  rows("p.two.bh", with_trials$id, p.adjust(p, "BH"), "tail")
}
