# Power by summing over everything that can happen, and by quadrature of the noncentral distributions.
binomial_two_sided <- function(n, p) { d <- dbinom(0:n, n, p); sapply(d, function(one) sum(d[d <= one * (1 + 1e-7)])) }
upper <- function(d) rev(cumsum(rev(d)))
fixed_points <- function(m) {  # by inclusion and exclusion, scaled to 1
  sapply(0:m, function(k) sum((-1)^(0:(m - k)) / factorial(0:(m - k))) / factorial(k))
}
times <- function(d, n) { all <- c("0" = 1); one <- setNames(d, seq_along(d) - 1); for (i in seq_len(n)) all <- sum_of(all, one); as.vector(all[order(as.numeric(names(all)))]) }
fisher_p <- function(x, y, n1, n2) fisher.test(rbind(c(x, y), c(n1 - x, n2 - y)))$p.value

power_results <- function(data) for (i in seq_len(nrow(data))) {
  r <- data[i, ]; key <- r$id; a <- r$alpha; n <- r$n
  say <- function(quantity, value, known = "tail") row(quantity, key, value, known)
  exact <- function(reject, null, truth) { say("alpha.actual", sum(null[reject])); say("power", sum(truth[reject])) }
  first <- function(reject) say("critical", if (any(reject)) which(reject)[1] - 1 else NA, "count")
  switch(r$kind,
    binom_greater = { null <- dbinom(0:n, n, r$p0); reject <- pmin(upper(null), 1) <= a; first(reject); exact(reject, null, dbinom(0:n, n, r$p1)) },
    binom_two = exact(binomial_two_sided(n, r$p0) <= a, dbinom(0:n, n, r$p0), dbinom(0:n, n, r$p1)),
    chisq_uniform_exact = {
      p <- as.numeric(strsplit(r$probs, ";")[[1]]); k <- length(p)
      counts <- as.matrix(expand.grid(rep(list(0:n), k))); counts <- counts[rowSums(counts) == n, ]
      reject <- apply(counts, 1, function(c) suppressWarnings(chisq.test(c)$p.value) <= a)
      say("alpha.actual", sum(apply(counts[reject, ], 1, dmultinom, prob = rep(1, k))), "optimum")
      say("power", sum(apply(counts[reject, ], 1, dmultinom, prob = p)), "optimum")
      lambda <- n * sum((p - 1 / k)^2) * k; mix <- 0:400
      say("power.noncentral", sum(dpois(mix, lambda / 2) * pchisq(qchisq(1 - a, k - 1), k - 1 + 2 * mix, lower.tail = FALSE))) },
    matching_mallows = {
      one <- fixed_points(r$k); truth <- one * exp(r$theta * 0:r$k); truth <- truth / sum(truth)
      null <- times(one, n); reject <- upper(null) <= a; first(reject); exact(reject, null, times(truth, n)); say("mean.correct", sum(truth * 0:r$k), "formula") },
    matching_known = {
      truth <- c(numeric(r$d), if (r$d < r$k) fixed_points(r$k - r$d) else 1); null <- times(fixed_points(r$k), n)
      say("power", sum(times(truth, n)[upper(null) <= a])) },
    paired_t = {  # the chi-square denominator integrated out
      df <- n - 1; limit <- qt(1 - a / 2, df)
      beyond <- function(s) (pnorm(limit * s / sqrt(df), r$d * sqrt(n), lower.tail = FALSE) + pnorm(-limit * s / sqrt(df), r$d * sqrt(n))) * 2 * s * dchisq(s^2, df)
      say("power", integrate(beyond, 0, sqrt(df) + 12, rel.tol = 1e-12, subdivisions = 2000)$value) },
    rm_anova = {
      lambda <- r$f^2 * n * r$k * r$eps / (1 - r$rho); d1 <- (r$k - 1) * r$eps; d2 <- d1 * (n - 1); limit <- qf(1 - a, d1, d2)
      mix <- 0:600; say("lambda", lambda, "formula")
      say("power", sum(dpois(mix, lambda / 2) * pbeta(d2 / (d2 + d1 * limit), d2 / 2, d1 / 2 + mix))) },
    fisher_two = {
      reject <- outer(0:n, 0:r$k, Vectorize(function(x, y) fisher_p(x, y, n, r$k) <= a))
      say("power", sum(outer(dbinom(0:n, n, r$p0), dbinom(0:r$k, r$k, r$p1))[reject])); say("alpha.actual", sum(outer(dbinom(0:n, n, r$p0), dbinom(0:r$k, r$k, r$p0))[reject])) },
    mafc_dprime = {
      share <- choice_share(r$d, r$k); say("pc", share, "optimum"); null <- dbinom(0:n, n, 1 / r$k)
      say("power", sum(dbinom(0:n, n, share)[upper(null) <= a]), "optimum") },
    betabinom_pool = {
      m <- r$k; size <- 1 / r$rho - 1; one <- sapply(0:m, function(k) choose(m, k) * beta(k + r$p1 * size, m - k + (1 - r$p1) * size) / beta(r$p1 * size, (1 - r$p1) * size))
      say("reject.rate", sum(times(one, n)[upper(dbinom(0:(n * m), n * m, r$p0)) <= a])); say("deff", 1 + (m - 1) * r$rho, "formula") })
}
