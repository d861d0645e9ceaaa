# Paired comparisons: Stigler's citations among four journals of statistics, baseball with an advantage at home (both from package
# BradleyTerry2), and judgements with ties and an order effect drawn here.
source("results.R")
suppressPackageStartupMessages(library(BradleyTerry2))

about_mean <- function(b, V) {  # of the abilities after the first
  K <- length(b) + 1; centre <- (diag(K) - 1 / K)[, -1]
  list(value = drop(centre %*% b), se = sqrt(diag(centre %*% V %*% t(centre))))
}
model_rows <- function(name, data, fit, items, log_likelihood, equal, pearson, deviance, df) {
  b <- coef(fit)[seq_len(items - 1)]; V <- vcov(fit)[seq_len(items - 1), seq_len(items - 1)]
  centred <- about_mean(b, V)
  rows(paste0(name, ".ability"), seq_len(items), centred$value); rows(paste0(name, ".se"), seq_len(items), centred$se)
  row(paste0(name, ".difference.se"), "3|2", sqrt(V[1, 1] + V[2, 2] - 2 * V[1, 2]))
  row(paste0(name, ".loglik"), "", log_likelihood); row(paste0(name, ".equal"), "", equal)
  row(paste0(name, ".pearson"), "", pearson); row(paste0(name, ".deviance"), "", deviance); row(paste0(name, ".df"), "", df)
}
# Without binomial coefficients, from the fitted probabilities of the first item.
kernel <- function(y1, y2, p) sum(y1 * log(p) + y2 * log(1 - p))

# A journal wins when the other one cites it.
counts <- countsToBinomial(citations); names(counts)[1:2] <- c("first", "second")
journals <- levels(counts$first)
write_data(data.frame(first = match(counts$first, journals), second = match(counts$second, journals), first_wins = counts$win1, second_wins = counts$win2, ties = 0), "citations.csv")
fit <- BTm(cbind(win1, win2), first, second, data = counts)
model_rows("citations", counts, fit, 4, kernel(counts$win1, counts$win2, fitted(fit)), fit$null.deviance - fit$deviance,
           sum(residuals(fit, "pearson")^2), deviance(fit), df.residual(fit))

# baseball: wins of the home team, which is the first one.
b <- baseball; teams <- levels(b$home.team)
write_data(data.frame(first = match(b$home.team, teams), second = match(b$away.team, teams), first_wins = b$home.wins, second_wins = b$away.wins, ties = 0), "baseball.csv")
b$home.team <- data.frame(team = b$home.team, at.home = 1); b$away.team <- data.frame(team = b$away.team, at.home = 0)
fit <- BTm(cbind(home.wins, away.wins), home.team, away.team, ~ team + at.home, id = "team", data = b)
home <- glm(cbind(home.wins, away.wins) ~ 1, binomial, baseball)
model_rows("baseball", b, fit, length(teams), kernel(baseball$home.wins, baseball$away.wins, fitted(fit)), deviance(home) - deviance(fit),
           sum(residuals(fit, "pearson")^2), deviance(fit), df.residual(fit))
row("baseball.order", "value", coef(fit)[["at.home"]]); row("baseball.order", "se", sqrt(vcov(fit)["at.home", "at.home"]))

# ties and order: the multinomial model as a log-linear one, counts being Poisson with a level for each ordered pair.
set.seed(21)
K <- 5; lambda <- c(0.2, -0.6, 0.9, 0, -0.5); alpha <- 0.35; tie <- log(0.7)
pairs <- subset(expand.grid(first = 1:K, second = 1:K), first != second)
outcomes <- t(apply(pairs, 1, function(p) { d <- lambda[p[1]] - lambda[p[2]] + alpha; rmultinom(1, 12, c(exp(d / 2), exp(-d / 2), exp(tie))) }))
pairs <- cbind(pairs, first_wins = outcomes[, 1], second_wins = outcomes[, 2], ties = outcomes[, 3])
write_data(pairs, "ties_and_order.csv")
long <- do.call(rbind, lapply(seq_len(nrow(pairs)), function(r) {
  x <- outer(c(0.5, -0.5, 0), (1:K == pairs$first[r]) - (1:K == pairs$second[r]))
  data.frame(cell = r, y = as.numeric(pairs[r, 3:5]), x, order = c(0.5, -0.5, 0), tie = c(0, 0, 1))
}))
tied_rows <- function(name, long, order) {
  right <- c(paste0("X", 2:K), if (order) "order", "tie")
  control <- glm.control(epsilon = 1e-14, maxit = 100)
  fit <- glm(reformulate(c(right, "factor(cell)"), "y"), poisson, long, control = control)
  equal <- glm(reformulate(c(if (order) "order", "tie", "factor(cell)"), "y"), poisson, long, control = control)
  # of a multinomial: the counts of a cell are given
  n <- tapply(long$y, long$cell, sum)[as.character(long$cell)]
  at <- list(coefficients = coef(fit)[right], V = vcov(fit)[right, right])
  centred <- about_mean(at$coefficients[1:(K - 1)], at$V[1:(K - 1), 1:(K - 1)])
  rows(paste0(name, ".ability"), 1:K, centred$value); rows(paste0(name, ".se"), 1:K, centred$se)
  row(paste0(name, ".difference.se"), "3|2", sqrt(at$V[1, 1] + at$V[2, 2] - 2 * at$V[1, 2]))
  if (order) { row(paste0(name, ".order"), "value", at$coefficients[["order"]]); row(paste0(name, ".order"), "se", sqrt(at$V["order", "order"])) }
  row(paste0(name, ".tie"), "value", at$coefficients[["tie"]]); row(paste0(name, ".tie"), "se", sqrt(at$V["tie", "tie"]))
  row(paste0(name, ".loglik"), "", sum(long$y * log(fitted(fit) / n))); row(paste0(name, ".equal"), "", deviance(equal) - deviance(fit))
  row(paste0(name, ".pearson"), "", sum(residuals(fit, "pearson")^2)); row(paste0(name, ".deviance"), "", deviance(fit)); row(paste0(name, ".df"), "", df.residual(fit))
}
tied_rows("ties_and_order", long, TRUE)
# The same judgements without regard to order: Davidson's model of the ten pairs.
swap <- pairs$first > pairs$second
merged <- aggregate(cbind(w1, w2, ties) ~ a + b, data.frame(a = pmin(pairs$first, pairs$second), b = pmax(pairs$first, pairs$second),
  w1 = ifelse(swap, pairs$second_wins, pairs$first_wins), w2 = ifelse(swap, pairs$first_wins, pairs$second_wins), ties = pairs$ties), sum)
long <- do.call(rbind, lapply(seq_len(nrow(merged)), function(r) {
  x <- outer(c(0.5, -0.5, 0), (1:K == merged$a[r]) - (1:K == merged$b[r]))
  data.frame(cell = r, y = as.numeric(merged[r, 3:5]), x, order = c(0.5, -0.5, 0), tie = c(0, 0, 1))
}))
tied_rows("ties", long, FALSE)

# All 2^15 outcomes of the comparisons of six items, each triad examined.
circular_triads <- function(K) {
  pairs <- combn(K, 2); triads <- combn(K, 3); outcomes <- 0:(2^ncol(pairs) - 1)
  beats <- function(i, j) { p <- which(pairs[1, ] == min(i, j) & pairs[2, ] == max(i, j)); bit <- (outcomes %/% 2^(p - 1)) %% 2; if (i < j) bit else 1 - bit }
  d <- 0
  for (t in seq_len(ncol(triads))) {
    x <- beats(triads[1, t], triads[2, t]); y <- beats(triads[2, t], triads[3, t]); z <- beats(triads[3, t], triads[1, t])
    d <- d + (x == y & y == z)
  }
  table(d)
}
for (K in 4:6) { t <- circular_triads(K); rows(paste0("triads.", K), names(t), as.numeric(t)) }

# Agreement of five judges about four items, from the definition; its null distribution by simulation of the pairs' convolution.
set.seed(22)
K <- 4; m <- 5; W <- matrix(0, K, K)
for (p in seq_len(choose(K, 2))) { ij <- combn(K, 2)[, p]; w <- rbinom(1, m, 0.75); W[ij[1], ij[2]] <- w; W[ij[2], ij[1]] <- m - w }
for (i in 1:K) rows("agreement.wins", paste(i, 1:K, sep = "|"), W[i, ])
S <- sum(choose(W[base::row(W) != col(W)], 2)); u <- 2 * S / (choose(m, 2) * choose(K, 2)) - 1
row("agreement", "u", u)
every <- as.matrix(expand.grid(rep(list(0:m), choose(K, 2))))  # wins of the first item in each of the six pairs
sums <- rowSums(choose(every, 2) + choose(m - every, 2)); weight <- apply(matrix(dbinom(every, m, 0.5), nrow(every)), 1, prod)
row("agreement", "p", sum(weight[sums >= S]))
chi <- 4 / (m - 2) * (S - choose(K, 2) * choose(m, 2) * (m - 3) / (m - 2) / 2); df <- choose(K, 2) * m * (m - 1) / (m - 2)^2
row("agreement", "chi_squared", chi); row("agreement", "df", df)
write_results("paired_comparisons_expected.csv")
