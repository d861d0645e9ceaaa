# Printed margins of three experiments: choices (exp, renderer, count), matching and recognition (exp, sex, correct, n).
share_rows <- function(table, key, k, n) {
  w <- wilson(k, n, .95); cp <- clopper_pearson(k, n, .95)
  row(paste0(table, ".prop"), key, k / n); row(paste0(table, ".wilson.lower"), key, w[1]); row(paste0(table, ".wilson.upper"), key, w[2])
  row(paste0(table, ".cp.lower"), key, cp[1], "tail"); row(paste0(table, ".cp.upper"), key, cp[2], "tail"); w
}
dprime <- function(p, m) uniroot(function(d) integrate(function(x) dnorm(x - d) * pnorm(x)^(m - 1), d - 12, d + 12, rel.tol = 1e-12)$value - p, c(-8, 8), tol = 1e-12)$root
fano <- function(p, m) { q <- c(p, rep((1 - p) / (m - 1), m - 1)); log2(m) + sum(q * log2(q)) }

seedpaper_results <- function(choices, matching, recognition) {
  X <- xtabs(count ~ factor(renderer, unique(renderer)) + factor(exp, unique(exp)), choices); R <- rownames(X); E <- colnames(X)
  for (b in c(E, "POOLED")) {
    x <- if (b == "POOLED") rowSums(X) else X[, b]; n <- sum(x)
    for (r in R) { row("t1.count", paste0(b, "|", r), x[[r]], "count"); share_rows("t1", paste0(b, "|", r), x[[r]], n) }
    X2 <- sum((x - mean(x))^2) / mean(x); row("t1.chisq", b, X2); row("t1.chisq.p", b, pchisq(X2, length(R) - 1, lower.tail = FALSE), "tail")
    if (b != "POOLED") { m <- uniform_multinomial(as.numeric(x)); row("t1.multinom.exact.p", b, m[1], "tail"); row("t1.multinom.chisqorder.p", b, m[2], "tail") }
    row("t1.image.p.greater", b, sum(dbinom(x[["image"]]:n, n, 1 / length(R))), "tail")
    for (i in 1:2) for (j in (i + 1):3) row("t1.pair.p.two", paste(b, R[i], R[j], sep = "|"), min(1, 2 * pbinom(min(x[c(i, j)]), sum(x[c(i, j)]), .5)), "tail")
  }
  row("t1.homogeneity.fisher.p", "", fisher.test(X)$p.value, "optimum")
  C <- Reduce(`+`, lapply(E, function(e) outer(rep(R, X[, e]), R, "==") * 1)); colnames(C) <- R
  row("t1.nested.signflip.image.sinusoid", "", sign_flip(C[, "image"] - C[, "sinusoid"]), "tail"); row("t1.nested.signflip.image.stochastic", "", sign_flip(C[, "image"] - C[, "stochastic"]), "tail")
  row("t1.nested.relabel.p", "", permuted_rows(C), "tail")
  p <- sum(C[, "image"]) / sum(C); row("t1.nested.deff.image", "", nrow(C) * var(C[, "image"]) / sum(C)^2 / (p * (1 - p) / sum(C)))
  preference <- rowSums(X)[["image"]] / sum(rowSums(X)[c("image", "sinusoid")])
  power <- function(n) { of <- dbinom(0:n, n, .5); reject <- sapply(0:n, function(k) sum(of[of <= of[k + 1] * (1 + 1e-7)]) <= .05); sum(dbinom(0:n, n, preference)[reject]) }
  enough <- sapply(20:400, power) >= .8; first <- which(sapply(seq_len(length(enough) - 6), function(i) all(enough[i:(i + 6)])))[1]
  row("t1.n.decisive.for80", "image|sinusoid", 19 + first, "count")
  all <- list()
  for (t in c("t2", "t3")) {
    d <- if (t == "t2") matching else recognition; chance <- if (t == "t2") c(all4 = 1 / 24, one = 1 / 4) else c(one = 1 / 6)
    for (b in c(unique(d$exp), "POOLED")) {
      e <- if (b == "POOLED") d else d[d$exp == b, ]; k <- sum(e$correct); n <- sum(e$n); all[[paste(t, b)]] <- c(k, n)
      row(paste0(t, ".k"), b, k, "count"); row(paste0(t, ".n"), b, n, "count"); w <- share_rows(t, b, k, n)
      for (name in names(chance)) row(paste0(t, ".p.greater"), paste0(b, "|chance=", name), sum(dbinom(k:n, n, chance[[name]])), "tail")
      of <- sapply(c("F", "M"), function(s) c(sum(e$correct[e$sex == s]), sum(e$n[e$sex == s]))); q <- of[1, ] / of[2, ]; f <- wilson(of[1, 1], of[2, 1], .95); m <- wilson(of[1, 2], of[2, 2], .95)
      tables <- dhyper(0:k, of[2, 1], of[2, 2], k); row(paste0(t, ".sex.fisher.p"), b, sum(tables[tables <= tables[of[1, 1] + 1] * (1 + 1e-7)]), "tail")
      row(paste0(t, ".sex.diff"), b, q[[1]] - q[[2]]); row(paste0(t, ".sex.newcombe.lower"), b, q[[1]] - q[[2]] - sqrt((q[[1]] - f[1])^2 + (m[2] - q[[2]])^2)); row(paste0(t, ".sex.newcombe.upper"), b, q[[1]] - q[[2]] + sqrt((f[2] - q[[1]])^2 + (q[[2]] - m[1])^2))
      if (t == "t3") for (i in 1:3) { p <- c(k / n, w)[i]; end <- c("", ".lower", ".upper")[i]; row(paste0("t3.dprime6", end), b, dprime(p, 6), "optimum"); row(paste0("t3.IT.equalerrors", end), b, fano(p, 6)) }
    }
  }
  for (b in c(unique(matching$exp), "POOLED")) {
    a <- all[[paste("t2", b)]]; r <- all[[paste("t3", b)]]; n <- a[2]; p <- c()
    for (n11 in 0:n) { n10 <- a[1] - n11; n01 <- r[1] - n11; if (n10 < 0 || n01 < 0 || n11 + n10 + n01 > n) next; p <- c(p, min(1, 2 * pbinom(min(n10, n01), n10 + n01, .5))) }
    row("t2t3.mcnemar.p.min", b, min(p), "tail"); row("t2t3.mcnemar.p.max", b, max(p), "tail")
    tables <- dhyper(0:(a[1] + r[1]), n, n, a[1] + r[1]); row("t2t3.fisher.p", b, sum(tables[tables <= tables[a[1] + 1] * (1 + 1e-7)]), "tail")
  }
}
