# Two one-sided tests of pairs, and the JZS Bayes factor by integration over the variance of the prior.
jzs <- function(t, n, df, scale) {
  prior <- function(g) exp(-0.5 * log(2 * pi) - 1.5 * log(g) - 1 / (2 * g))
  likelihood <- function(g) { w <- 1 + n * g * scale^2; w^-0.5 * ((1 + t^2 / (w * df)) / (1 + t^2 / df))^(-(df + 1) / 2) }
  integrate(function(u) likelihood(exp(u)) * prior(exp(u)) * exp(u), -30, 60, rel.tol = 1e-12, subdivisions = 5000)$value
}
equivalence_results <- function(data, lower, upper, alpha) {
  d <- data$a - data$b; n <- length(d); se <- sd(d) / sqrt(n); t <- mean(d) / se
  row("diff", "", mean(d)); row("se", "", se)
  above <- t.test(d, mu = lower, alternative = "greater"); below <- t.test(d, mu = upper, alternative = "less")
  row("tost.t.lower", "", above$statistic[[1]]); row("tost.t.upper", "", below$statistic[[1]])
  row("tost.p.lower", "", above$p.value, "tail"); row("tost.p.upper", "", below$p.value, "tail")
  p <- max(above$p.value, below$p.value); row("tost.p", "", p, "tail")
  half <- qt(1 - alpha, n - 1) * se
  row("ci.lower", "", mean(d) - half); row("ci.upper", "", mean(d) + half)
  row("equivalent", "", p < alpha); row("dz", "", mean(d) / sd(d)); row("t", "", t); row("t.p.two", "", t.test(d)$p.value, "tail")
  row("jzs.bf10", "0.7071", jzs(t, n, n - 1, sqrt(2) / 2), "optimum"); row("jzs.bf10", "1", jzs(t, n, n - 1, 1), "optimum")
}
