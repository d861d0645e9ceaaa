# The best of K for every sample: subject, sample, choice (NA where none was made).
every <- function(...) as.matrix(expand.grid(...))

# All counts of n choices among K, with the probability of each under equal shares.
uniform_multinomial <- function(x) {
  n <- sum(x); K <- length(x)
  all <- every(rep(list(0:n), K)); all <- all[rowSums(all) == n, , drop = FALSE]
  p <- apply(all, 1, dmultinom, size = n, prob = rep(1 / K, K))
  c(sum(p[p <= dmultinom(x, n, rep(1 / K, K)) * (1 + 1e-7)]), sum(p[rowSums(all^2) >= sum(x^2)]))
}

# The share of all ways to permute each row on its own that give as large a sum of squared column totals.
permuted_rows <- function(counts) {
  if (!nrow(counts)) return(1)
  P <- permutations(ncol(counts))
  totals <- list(matrix(0, 1, ncol(counts)))
  sums <- matrix(0, 1, ncol(counts))
  for (i in seq_len(nrow(counts)))
    sums <- do.call(rbind, lapply(seq_len(nrow(P)), function(k) sweep(sums, 2, counts[i, P[k, ]], "+")))
  mean(rowSums(sums^2) >= sum(colSums(counts)^2))
}

# Means of unit normal values such that value j is the largest with probability p[j].
best_of <- function(p) {
  K <- length(p)
  largest <- function(mu, j) integrate(function(z) vapply(z, function(one)
    dnorm(one - mu[j]) * prod(pnorm(one - mu[-j])), 0), -12 + mu[j], 12 + mu[j], rel.tol = 1e-12, subdivisions = 1000)$value
  mu <- qnorm(p)
  for (step in 1:500) {
    got <- vapply(1:K, function(j) largest(mu, j), 0)
    move <- qnorm(p) - qnorm(got)
    mu <- mu + move - mean(move)
    if (max(abs(got - p)) < 1e-11) break
  }
  mu - mean(mu)
}

selection_block <- function(block, x, target, confidence, pooled) {
  n <- sum(x); K <- length(x); key <- paste0(block, "|", names(x))
  row("n.valid", block, n, "count")
  for (j in 1:K) {
    row("count", key[j], x[[j]], "count"); row("prop", key[j], x[[j]] / n)
    w <- wilson(x[[j]], n, confidence); row("wilson.lower", key[j], w[1]); row("wilson.upper", key[j], w[2])
    cp <- clopper_pearson(x[[j]], n, confidence); row("cp.lower", key[j], cp[1], "tail"); row("cp.upper", key[j], cp[2], "tail")
    # Goodman: (p - x/n)^2 = A p (1 - p) / n, solved for p.
    A <- qnorm(1 - (1 - confidence) / K / 2)^2; a <- 1 + A / n; b <- -(2 * x[[j]] / n + A / n); root <- sqrt(b^2 - 4 * a * (x[[j]] / n)^2)
    row("goodman.lower", key[j], (-b - root) / (2 * a)); row("goodman.upper", key[j], (-b + root) / (2 * a))
  }
  X2 <- sum(x^2) * K / n - n; G <- 2 * sum(x[x > 0] * log(x[x > 0] * K / n))
  row("chisq", block, X2); row("chisq.df", block, K - 1, "count"); row("chisq.p", block, pchisq(X2, K - 1, lower.tail = FALSE), "tail")
  row("G", block, G); row("G.p", block, pchisq(G, K - 1, lower.tail = FALSE), "tail"); row("cramer.w", block, sqrt(X2 / n))
  if (!pooled) { m <- uniform_multinomial(x); row("multinom.exact.p", block, m[1], "tail"); row("multinom.chisqorder.p", block, m[2], "tail") }
  p <- pbinom(x[[target]] - 1, n, 1 / K, lower.tail = FALSE); row("target.p.greater", block, p, "tail")
  y <- if (any(x == 0)) x + .5 else x; row("luce.addhalf", block, any(x == 0))
  for (j in setdiff(names(x), target)) { row("luce.logworth", paste0(block, "|", j), log(y[[j]] / y[[target]])); row("luce.se", paste0(block, "|", j), sqrt(1 / y[[j]] + 1 / y[[target]])) }
  rows("thurstone.firstchoice.mu", key, best_of(y / sum(y)), "optimum")
  p
}

selection_results <- function(data, renderers, target, confidence) {
  made <- data[!is.na(data$choice), ]; samples <- unique(data$sample); K <- length(renderers)
  count <- function(d) { x <- sapply(renderers, function(r) sum(d$choice == r)); names(x) <- renderers; x }
  p <- sapply(samples, function(s) selection_block(s, count(made[made$sample == s, ]), target, confidence, FALSE))
  selection_block("POOLED", count(made), target, confidence, TRUE)
  rows("target.p.greater.holm", samples, p.adjust(p, "holm"), "tail")
  people <- unique(made$subject); N <- length(people)
  C <- do.call(rbind, lapply(people, function(u) count(made[made$subject == u, ]))); m <- rowSums(C); share <- C[, target] / m
  row("subj.n", "", N, "count"); row("subj.mean", target, mean(share)); row("subj.sd", target, sd(share))
  t <- if (N > 1 && var(share) > 0) (mean(share) - 1 / K) / sqrt(var(share) / N) else NA
  half <- if (is.na(t)) NA else qt(.5 + confidence / 2, N - 1) * sqrt(var(share) / N)
  row("subj.t", target, t); row("subj.t.df", target, N - 1, "count"); row("subj.t.p.two", target, 2 * pt(-abs(t), N - 1), "tail")
  row("subj.ci.lower", target, mean(share) - half); row("subj.ci.upper", target, mean(share) + half)
  P <- sum(C[, target]) / sum(m); se <- sqrt(N * var(C[, target] - P * m)) / sum(m); binomial <- sqrt(P * (1 - P) / sum(m))
  row("pooled.se.cluster", target, se); row("pooled.se.binom", target, binomial); row("pooled.deff", target, if (binomial > 0) (se / binomial)^2 else NA)
  flips <- c()
  for (a in seq_len(K - 1)) for (b in (a + 1):K) {
    key <- paste0(renderers[a], "|", renderers[b]); d <- C[, a] - C[, b]; flips[key] <- sign_flip(d)
    row("signflip.diff", key, sum(d), "count"); row("signflip.p.two", key, flips[[key]], "tail")
    n <- sum(C[, c(a, b)]); row("pairwise.binom.p.two", key, if (n) min(1, 2 * pbinom(min(sum(C[, a]), sum(C[, b])), n, .5)) else 1, "tail")
  }
  rows("signflip.p.two.holm", names(flips), p.adjust(flips, "holm"), "tail")
  row("relabel.exact.p", "", permuted_rows(C), "tail")
  first <- function(u, s) { z <- data$choice[data$subject == u & data$sample == s]; if (length(z)) z[1] == target else NA }
  B <- outer(unique(data$subject), samples, Vectorize(first)) * 1; B <- B[!is.na(rowSums(B)), , drop = FALSE]; J <- ncol(B)
  row("cochran.n.complete", target, nrow(B), "count")
  within <- sum(B) - sum(rowSums(B)^2) / J
  Q <- if (within > 0) (J - 1) * J * sum((colMeans(B) - mean(B))^2) * nrow(B)^2 / J / within else NA
  row("cochran.Q", target, Q); row("cochran.df", target, J - 1, "count")
  if (!is.na(Q)) { row("cochran.p", target, pchisq(Q, J - 1, lower.tail = FALSE), "tail"); row("cochran.exact.p", target, permuted_rows(B), "tail") }
  for (a in seq_len(J - 1)) for (b in (a + 1):J) {
    key <- paste0(samples[a], "|", samples[b]); only <- c(sum(B[, a] > B[, b]), sum(B[, a] < B[, b]))
    row("mcnemar.b", key, only[1], "count"); row("mcnemar.c", key, only[2], "count"); row("mcnemar.exact.p", key, min(1, 2 * pbinom(min(only), sum(only), .5)), "tail")
  }
}
