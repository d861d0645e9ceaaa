# Intraclass correlations of complete ratings, the mean squares from aov.
icc_results <- function(data, confidence) {
  data$target <- factor(data$target, unique(data$target)); data$rater <- factor(data$rater, unique(data$rater))
  n <- nlevels(data$target); k <- nlevels(data$rater); names <- c("ICC1", "ICC2", "ICC3", "ICC1k", "ICC2k", "ICC3k")
  ms <- summary(aov(score ~ target + rater, data))[[1]][["Mean Sq"]]; b <- ms[1]; j <- ms[2]; e <- ms[3]
  w <- (j * (k - 1) + e * (n - 1) * (k - 1)) / (n * (k - 1))
  icc1 <- (b - w) / (b + (k - 1) * w); icc2 <- (b - e) / (b + (k - 1) * e + k * (j - e) / n); icc3 <- (b - e) / (b + (k - 1) * e)
  rows("icc", names, c(icc1, icc2, icc3, (b - w) / b, (b - e) / (b + (j - e) / n), (b - e) / b))
  f1 <- b / w; f3 <- b / e; f <- c(f1, f3, f3, f1, f3, f3); df1 <- rep(n - 1, 6); df2 <- rep(c(n * (k - 1), (n - 1) * (k - 1), (n - 1) * (k - 1)), 2)
  rows("icc.F", names, f); rows("icc.df1", names, df1, "count"); rows("icc.df2", names, df2, "count")
  rows("icc.p", names, pf(f, df1, df2, lower.tail = FALSE), "tail")
  above <- 1 - (1 - confidence) / 2
  low <- function(i) f[i] / qf(above, df1[i], df2[i]); high <- function(i) f[i] * qf(above, df2[i], df1[i]); of <- function(x) (x - 1) / (x + k - 1)
  # of ICC2 [Shrout 1979]: Satterthwaite's degrees of freedom
  ratio <- j / e; rest <- n * (1 + (k - 1) * icc2) - k * icc2
  df <- (k - 1) * (n - 1) * (k * icc2 * ratio + rest)^2 / ((n - 1) * k^2 * icc2^2 * ratio^2 + rest^2)
  u <- qf(above, n - 1, df); l <- qf(above, df, n - 1); errors <- k * j + (k * n - k - n) * e
  low2 <- n * (b - u * e) / (u * errors + n * b); high2 <- n * (l * b - e) / (errors + n * l * b); mean_of <- function(x) x * k / (1 + x * (k - 1))
  rows("icc.lower", names, c(of(low(1)), low2, of(low(3)), 1 - 1 / low(4), mean_of(low2), 1 - 1 / low(6)))
  rows("icc.upper", names, c(of(high(1)), high2, of(high(3)), 1 - 1 / high(4), mean_of(high2), 1 - 1 / high(6)))
  m <- tapply(data$score, list(data$target, data$rater), mean)
  row("cronbach.alpha", "", k / (k - 1) * (1 - sum(apply(m, 2, var)) / var(rowSums(m))))
}
