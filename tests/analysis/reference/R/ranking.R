# Rankings: trial, subject, item, rank (NA: offered, and behind all that were ranked).
friedman_rows <- function(M) {
  R <- t(apply(M, 1, rank)); N <- nrow(M); K <- ncol(M)
  # The ratio of spreads of ranks, between items and in all, of which the usual formula is a shorter way to write.
  X2 <- N * (K - 1) * sum((colMeans(R) - (K + 1) / 2)^2) * N / sum((R - (K + 1) / 2)^2); F <- (N - 1) * X2 / (N * (K - 1) - X2)
  row("friedman.chisq", "", X2); row("friedman.p", "", pchisq(X2, K - 1, lower.tail = FALSE), "tail"); row("kendall.W", "", X2 / N / (K - 1))
  row("iman.davenport.F", "", F); row("iman.davenport.p", "", pf(F, K - 1, (K - 1) * (N - 1), lower.tail = FALSE), "tail")
  R
}
ranking_results <- function(data, items) {
  K <- length(items); full <- function(b) c(0, b); W <- matrix(0, K, K); stages <- list()
  for (t in unique(data$trial)) {
    e <- data[data$trial == t, ]; e <- e[order(e$rank), ]; chosen <- sum(!is.na(e$rank))
    for (s in seq_len(min(chosen, nrow(e) - 1))) { left <- match(e$item[s:nrow(e)], items); stages[[length(stages) + 1]] <- list(left = left, subject = e$subject[1]); W[left[1], left[-1]] <- W[left[1], left[-1]] + 1 }
  }
  strong <- all_reach_all(W > 0); row("n.stages", "", length(stages), "count"); row("strongly.connected", "", strong)
  if (strong) {
    # Hunter's iteration for the worths, then the general optimiser.
    w <- rep(1, K); for (i in 1:300) { below <- numeric(K); for (s in stages) below[s$left] <- below[s$left] + 1 / sum(w[s$left]); w <- tabulate(sapply(stages, function(s) s$left[1]), K) / below; w <- w / w[1] }
    f <- function(b) sum(sapply(stages, function(s) full(b)[s$left[1]] - log(sum(exp(full(b)[s$left]))))); b <- largest(f, log(w[-1])); V <- curvature(f, b)
    centre <- rbind(0, diag(K - 1)) - 1 / K; p <- exp(full(b)) / sum(exp(full(b)))
    rows("pl.logworth", items, full(b), "optimum"); rows("pl.se", items, full(sqrt(diag(V))), "optimum"); rows("pl.worth", items, p, "optimum")
    rows("pl.logworth.sumzero", items, full(b) - mean(full(b)), "optimum"); rows("pl.se.sumzero", items, sqrt(diag(centre %*% V %*% t(centre))), "optimum")
    row("pl.loglik", "", f(b), "optimum"); row("pl.loglik.equal", "", f(0 * b)); row("pl.lr", "", 2 * (f(b) - f(0 * b)), "optimum"); row("pl.lr.p", "", pchisq(2 * (f(b) - f(0 * b)), K - 1, lower.tail = FALSE), "optimum")
    score <- sapply(stages, function(s) { z <- numeric(K); z[s$left[1]] <- 1; z[s$left] <- z[s$left] - exp(full(b))[s$left] / sum(exp(full(b))[s$left]); z[-1] })
    U <- rowsum(t(matrix(score, K - 1)), sapply(stages, `[[`, "subject")); rows("pl.se.cluster", items, full(sqrt(diag(V %*% t(U) %*% U %*% V))), "optimum")
  } else row("pl.status", "", "not_estimable")
  if (all(table(data$trial) == K) && !anyNA(data$rank)) {
    M <- t(sapply(unique(data$trial), function(t) { e <- data[data$trial == t, ]; e$rank[match(items, e$item)] }))
    friedman_rows(M); row("friedman.df", "", K - 1, "count"); rows("mean.rank", items, colMeans(M))
  }
}
# Scores: subject, item, score.
rating_results <- function(data, items) {
  M <- t(sapply(unique(data$subject), function(u) sapply(items, function(i) data$score[data$subject == u & data$item == i][1]))); M <- M[!is.na(rowSums(M)), , drop = FALSE]
  row("n.complete", "", nrow(M), "count"); R <- friedman_rows(M); rows("mean.rank", items, colMeans(R)); p <- c()
  for (a in seq_len(ncol(M) - 1)) for (b in (a + 1):ncol(M)) {
    key <- paste0(items[a], "|", items[b]); d <- M[, a] - M[, b]; d <- d[d != 0]; r <- rank(abs(d)); p[key] <- sign_flip(2 * r * sign(d))
    row("wilcoxon.n", key, length(d), "count"); row("wilcoxon.Wplus", key, sum(r[d > 0])); row("wilcoxon.exact.p.two", key, p[[key]], "tail"); row("wilcoxon.rankbiserial", key, if (length(d)) sum(sign(d) * r) / sum(r) else NA)
  }
  rows("wilcoxon.exact.p.holm", names(p), p.adjust(p, "holm"), "tail")
}
