# Internal consistency and principal components, of 40 respondents (or items) on six scales.
source("results.R")
set.seed(11)
n <- 40
common <- rnorm(n); second <- rnorm(n)
values <- round(cbind(4 + common, 4 + 0.8 * common + 0.5 * second, 3 + 0.6 * common - 0.7 * second, 5 + 0.9 * common,
                      10 + 20 * second, 100 - 3 * second + common) + matrix(rnorm(6 * n, 0, 0.7), n), 3)
colnames(values) <- paste0("scale_", 1:6)
write_data(as.data.frame(values), "scales.csv")

# Cronbach's alpha of the first four by its first formula, with the limits of Feldt.
items <- values[, 1:4]; k <- ncol(items)
alpha <- k / (k - 1) * (1 - sum(apply(items, 2, var)) / var(rowSums(items)))
row("alpha", "value", alpha)
row("alpha", "low", 1 - (1 - alpha) * qf(0.975, n - 1, (n - 1) * (k - 1)))
row("alpha", "high", 1 - (1 - alpha) * qf(0.025, n - 1, (n - 1) * (k - 1)))
# The same as package psych computes them.
stopifnot(all.equal(psych::alpha(as.data.frame(items))$total$raw_alpha, alpha),
          all.equal(unlist(psych::alpha(as.data.frame(items))$feldt[c("lower.ci", "upper.ci")], use.names = FALSE),
                    c(1 - (1 - alpha) * qf(0.975, n - 1, (n - 1) * (k - 1)), 1 - (1 - alpha) * qf(0.025, n - 1, (n - 1) * (k - 1)))))

# Principal components by the singular values of the standardised table (prcomp), not by the correlation matrix.
p <- prcomp(values, scale. = TRUE)
sign_of <- apply(p$rotation, 2, function(v) sign(v[which.max(abs(v))]))
rotation <- sweep(p$rotation, 2, sign_of, "*"); scores <- sweep(p$x, 2, sign_of, "*")
rows("eigenvalue", 1:6, p$sdev^2)
for (j in 1:6) rows("loading", paste(1:6, j, sep = "|"), rotation[, j] * p$sdev[j])
for (j in 1:6) rows("score", paste(c(1, 17, 40), j, sep = "|"), scores[c(1, 17, 40), j])

# Horn's parallel analysis with many data sets: limits to about 0.003.
set.seed(12)
noise <- replicate(40000, eigen(cor(matrix(rnorm(n * 6), n)), TRUE, TRUE)$values)
rows("parallel.limit", 1:6, apply(noise, 1, quantile, 0.95)); rows("parallel.mean", 1:6, rowMeans(noise))
write_results("scales_expected.csv")
