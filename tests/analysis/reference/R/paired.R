# Judgements of two: subject, first, second, winner (an item or tie; NA where nothing was judged).
paired_results <- function(data, items, confidence) {
  d <- data[!is.na(data$winner), ]; K <- length(items)
  won <- function(i, j) sum(d$winner == i & (d$first == j | d$second == j)); tied <- function(i, j) sum(d$winner == "tie" & ((d$first == i & d$second == j) | (d$first == j & d$second == i)))
  W <- outer(items, items, Vectorize(function(i, j) if (i == j) 0 else won(i, j))); T <- outer(items, items, Vectorize(function(i, j) if (i == j) 0 else tied(i, j)))
  for (i in 1:K) for (j in setdiff(1:K, i)) row("wins", paste0(items[i], "|", items[j]), W[i, j], "count")
  row("ties", "", sum(d$winner == "tie"), "count"); strong <- all_reach_all(W > 0); row("strongly.connected", "", strong)
  pairs <- expand.grid(i = 1:K, j = 1:K); pairs <- pairs[pairs$i < pairs$j, ]; pairs$n <- W[as.matrix(pairs)] + t(W)[as.matrix(pairs)]; pairs$y <- W[as.matrix(pairs[, 1:2])]
  used <- pairs[pairs$n > 0, ]; full <- function(b) c(0, b); apart <- function(b) full(b)[used$i] - full(b)[used$j]
  loglik <- function(link) function(b) sum(used$y * link(apart(b), log.p = TRUE) + (used$n - used$y) * link(-apart(b), log.p = TRUE))
  best <- sum(ifelse(used$y > 0, used$y * log(used$y / used$n), 0) + ifelse(used$y < used$n, (used$n - used$y) * log(1 - used$y / used$n), 0))
  information <- function(b) { e <- apart(b); X <- outer(used$i, 2:K, "==") - outer(used$j, 2:K, "=="); crossprod(X * sqrt(used$n * plogis(e) * plogis(-e))) }
  if (strong) {
    f <- loglik(plogis); b <- largest(f, rep(0, K - 1)); V <- solve(information(b))
    centre <- rbind(0, diag(K - 1)) - 1 / K
    rows("bt.ability", items, full(b), "optimum"); rows("bt.se", items, full(sqrt(diag(V))), "optimum")
    rows("bt.ability.sumzero", items, full(b) - mean(full(b)), "optimum"); rows("bt.se.sumzero", items, sqrt(diag(centre %*% V %*% t(centre))), "optimum")
    rows("bt.worth", items, exp(full(b)) / sum(exp(full(b))), "optimum")
    deviance <- 2 * (best - f(b)); df <- nrow(used) - K + 1; row("bt.deviance", "", deviance, "optimum"); row("bt.df", "", df, "count")
    if (df > 0) row("bt.gof.p", "", pchisq(deviance, df, lower.tail = FALSE), "optimum")
    lr <- 2 * (f(b) - f(0 * b)); row("bt.lr.equal", "", lr, "optimum"); row("bt.lr.equal.p", "", pchisq(lr, K - 1, lower.tail = FALSE), "optimum")
    Z <- rbind(0, diag(K - 1))
    for (r in seq_len(nrow(used))) { key <- paste0(items[used$i[r]], "|", items[used$j[r]]); z <- Z[used$i[r], ] - Z[used$j[r], ]; row("bt.diff", key, sum(z * b), "optimum"); row("bt.diff.se", key, sqrt(sum(z * (V %*% z))), "optimum"); row("bt.pij", key, plogis(sum(z * b)), "optimum") }
    e <- d[d$winner != "tie", ]; e$a <- match(e$first, items); e$b <- match(e$second, items); hit <- e$winner == e$first
    residual <- hit - plogis(full(b)[e$a] - full(b)[e$b]); X <- Z[e$a, , drop = FALSE] - Z[e$b, , drop = FALSE]
    scores <- do.call(rbind, lapply(split(seq_len(nrow(e)), e$subject), function(r) colSums(X[r, , drop = FALSE] * residual[r])))
    rows("bt.se.cluster", items, full(sqrt(diag(V %*% t(scores) %*% scores %*% V))), "optimum")
    g <- function(x) sum(plogis((2 * hit - 1) * (x[1] + full(x[-1])[e$a] - full(x[-1])[e$b]), log.p = TRUE)); x <- largest(g, c(0, b))
    row("bt.order.beta", "first", x[1], "optimum"); row("bt.order.se", "first", sqrt(curvature(g, x)[1, 1]), "optimum"); row("bt.order.lr", "first", 2 * (g(x) - g(c(0, b))), "optimum"); row("bt.order.lr.p", "first", pchisq(2 * (g(x) - g(c(0, b))), 1, lower.tail = FALSE), "optimum")
    h <- loglik(pnorm); s <- largest(h, b / 1.7); u <- apart(s); X <- outer(used$i, 2:K, "==") - outer(used$j, 2:K, "==")
    rows("thurstone.ml", items, full(s), "optimum"); rows("thurstone.ml.se", items, full(sqrt(diag(solve(crossprod(X * sqrt(used$n * dnorm(u)^2 / pnorm(u) / pnorm(-u))))))), "optimum"); row("thurstone.ml.deviance", "", 2 * (best - h(s)), "optimum")
  } else row("bt.status", "", "not_estimable")
  if (all_reach_all(W + t(W) > 0)) {
    penalised <- function(b) loglik(plogis)(b) + determinant(information(b))$modulus[1] / 2; b <- largest(penalised, rep(0, K - 1))
    rows("bt.firth.ability", items, full(b), "optimum"); rows("bt.firth.se", items, full(sqrt(diag(solve(information(b))))), "optimum")
  } else row("bt.firth.status", "", "not_estimable")
  if (all(pairs$n > 0)) {
    share <- function(i, j) { n <- W[i, j] + W[j, i]; if (i == j) .5 else min(max(W[i, j] / n, .5 / n), 1 - .5 / n) }
    s <- rowMeans(qnorm(outer(1:K, 1:K, Vectorize(share)))); rows("thurstone.ls", items, s)
    X2 <- sum(pairs$n * (2 * asin(sqrt(pairs$y / pairs$n)) - 2 * asin(sqrt(pnorm(s[pairs$i] - s[pairs$j]))))^2); df <- choose(K - 1, 2)
    row("thurstone.mosteller.chisq", "", X2); row("thurstone.mosteller.df", "", df, "count"); if (df > 0) row("thurstone.mosteller.p", "", pchisq(X2, df, lower.tail = FALSE), "tail")
    row("thurstone.clipped.cells", "", sum(pairs$y %in% 0 | pairs$y == pairs$n), "count")
  }
  if (strong && sum(T) > 0) {
    all <- expand.grid(i = 1:K, j = 1:K); all <- all[all$i < all$j, ]; cell <- as.matrix(all); counts <- cbind(W[cell], t(W)[cell], T[cell]); keep <- rowSums(counts) > 0; counts <- counts[keep, , drop = FALSE]; all <- all[keep, ]
    g <- function(x) { l <- full(x[-K]); w <- cbind(exp(l[all$i]), exp(l[all$j]), exp(x[K] + (l[all$i] + l[all$j]) / 2)); sum(counts * log(w / rowSums(w))) }
    x <- largest(g, rep(0, K)); V <- curvature(g, x); top <- sum(ifelse(counts > 0, counts * log(counts / rowSums(counts)), 0))
    rows("davidson.ability", items, full(x[-K]), "optimum"); rows("davidson.se", items, full(sqrt(diag(V))[-K]), "optimum"); row("davidson.lognu", "", x[K], "optimum"); row("davidson.lognu.se", "", sqrt(V[K, K]), "optimum")
    row("davidson.deviance", "", 2 * (top - g(x)), "optimum"); row("davidson.df", "", 2 * nrow(all) - K, "count")
  }
  for (u in unique(d$subject)) {
    e <- d[d$subject == u, ]; key <- apply(cbind(e$first, e$second), 1, function(x) paste(sort(x), collapse = " "))
    if (K < 3 || nrow(e) != choose(K, 2) || anyDuplicated(key) || any(e$winner == "tie")) next
    beats <- function(i, j) any(e$winner == i & (e$first == j | e$second == j)); triads <- combn(items, 3)
    circular <- sum(apply(triads, 2, function(t) length(unique(c(sum(beats(t[1], t[2]), beats(t[1], t[3])), sum(beats(t[2], t[1]), beats(t[2], t[3])), sum(beats(t[3], t[1]), beats(t[3], t[2]))))) == 1))
    row("circular.triads", u, circular, "count"); row("zeta", u, 1 - circular / (if (K %% 2) (K^3 - K) / 24 else (K^3 - 4 * K) / 24))
  }
}
