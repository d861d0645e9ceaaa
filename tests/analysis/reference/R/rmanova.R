# Analysis of variance of repeated measures: every effect by comparing regressions of its contrasts (polynomial ones) with and
# without the hypothesis.
rmanova_results <- function(data, within, between = NULL, type = 3, trend = NULL, scale = "linear", confidence = .95) {
  names_of <- names(within); data <- data[!is.na(data$y), ]; data$subject <- as.character(data$subject)
  cells <- Reduce(function(a, b) as.vector(t(outer(a, b, paste, sep = "|"))), within)
  data$cell <- apply(data[, names_of, drop = FALSE], 1, paste, collapse = "|"); people <- unique(data$subject)
  y <- t(sapply(people, function(s) sapply(cells, function(c) mean(data$y[data$subject == s & data$cell == c]))))
  gone <- apply(y, 1, function(one) any(is.nan(one))); row("subjects.dropped", "", if (any(gone)) paste(people[gone], collapse = ";") else "none")
  y <- y[!gone, , drop = FALSE]; people <- people[!gone]; n <- nrow(y); row("n.subjects", "", n, "count")
  group <- if (is.null(between)) factor(rep("all", n)) else factor(data[match(people, data$subject), names(between)], between[[1]])
  g <- nlevels(group); f <- n - g
  effects <- list(); errors <- c()
  for (code in order(sapply(0:(2^length(within) - 1), function(i) sum(bitwAnd(i, 2^(0:9)) > 0))) - 1) {
    inside <- bitwAnd(code, 2^(seq_along(within) - 1)) > 0
    contrast <- matrix(1)
    for (i in seq_along(within)) { k <- length(within[[i]]); contrast <- kronecker(contrast, if (inside[i]) contr.poly(k) else matrix(1 / sqrt(k), k, 1)) }
    z <- y %*% contrast; rss <- function(fit) sum(resid(fit)^2); full <- if (g > 1) lm(z ~ group) else lm(z ~ 1)
    s <- crossprod(as.matrix(resid(full))); q <- ncol(z); errors <- c(errors, sum(diag(s)))
    if (any(inside)) {
      sum_coded <- if (g > 1) model.matrix(~ group, contrasts.arg = list(group = "contr.sum"))
      without <- if (type == 2 || g == 1) rss(lm(z ~ 0)) - rss(lm(z ~ 1)) else rss(lm(z ~ 0 + sum_coded[, -1])) - rss(full)
      effects[[paste(names_of[inside], collapse = ":")]] <- list(ss = without, df = q, s = s, q = q, between = FALSE)
    }
    if (g > 1) effects[[paste(c(names(between), names_of[inside]), collapse = ":")]] <- list(ss = rss(lm(z ~ 1)) - rss(full), df = q * (g - 1), s = s, q = q, between = TRUE)
  }
  row("SS.error.total", "", sum(errors)); measured <- sum(sapply(effects, function(e) e$between * e$ss))
  for (key in names(effects)) {
    e <- effects[[key]]; sse <- sum(diag(e$s)); df2 <- e$q * f; F <- (e$ss / e$df) / (sse / df2)
    row("SS", key, e$ss); row("SS.error", key, sse); row("df1", key, e$df, "count"); row("df2", key, df2, "count"); row("F", key, F); row("p", key, pf(F, e$df, df2, lower.tail = FALSE), "tail")
    row("pes", key, 1 / (1 + sse / e$ss)); row("ges", key, e$ss / (e$ss + sum(errors))); if (g > 1) row("ges.observed", key, e$ss / (sum(errors) + measured + (if (e$between) 0 else e$ss)))
    row("omega2.partial", key, e$df * (F - 1) / (e$df * F + df2 + 1))
    if (e$q < 2) next
    l <- eigen(e$s, TRUE, TRUE)$values; gg <- mean(l)^2 / mean(l^2); hf <- function(N) (N * e$q * gg - 2) / (e$q * (f - e$q * gg)); p_at <- function(eps) pf(F, e$df * eps, df2 * eps, lower.tail = FALSE)
    row("eps.GG", key, gg); row("eps.lower", key, 1 / e$q); row("eps.HF.lecoutre", key, hf(f + 1)); row("eps.HF.original", key, hf(n))
    row("p.GG", key, p_at(gg), "tail"); row("p.HF", key, p_at(min(1, hf(f + 1))), "tail"); row("p.lower", key, p_at(1 / e$q), "tail")
    if (f < e$q) { row("mauchly.W", key, "undefined"); next }
    q <- e$q; w <- det(e$s) / mean(diag(e$s))^q; rho <- 1 - (2 * q^2 + q + 2) / (6 * q * f); x2 <- -f * rho * log(w); df <- q * (q + 1) / 2 - 1
    beyond <- function(k) pchisq(x2, k, lower.tail = FALSE)
    second <- function(p) beyond(df) + (q + 2) * (q - 1) * (q - 2) * (2 * q^3 + 6 * q^2 + 3 * p + 2) / (288 * (f * q * rho)^2) * (beyond(df + 4) - beyond(df))
    row("mauchly.W", key, w); row("mauchly.chisq", key, x2); row("mauchly.df", key, df, "count"); row("mauchly.p.firstorder", key, beyond(df), "tail")
    row("mauchly.p.anderson", key, second(q), "tail"); row("mauchly.p.car", key, second(length(cells)), "tail")
  }
  for (name in levels(group)) {
    part <- y[group == name, , drop = FALSE]; k <- nrow(part); t <- qt(0.5 + confidence / 2, k - 1); key <- paste(name, cells, sep = "|")
    rows("cell.mean", key, colMeans(part)); rows("cell.ci.half", key, t * apply(part, 2, sd) / sqrt(k))
    own <- sweep(part, 1, rowMeans(part)); rows("cell.ci.half.morey", key, t * apply(own, 2, sd) / sqrt(k) * sqrt(ncol(y) / (ncol(y) - 1)))
  }
  for (i in seq_along(within)) {
    name <- names_of[i]; levels <- within[[i]]; place <- sapply(strsplit(cells, "|", fixed = TRUE), `[`, i)
    marginal <- sapply(levels, function(l) rowMeans(y[, place == l, drop = FALSE]))
    if (identical(trend, name)) {
      x <- as.numeric(levels); if (scale == "log10") x <- log10(x)
      curves <- contr.poly(length(x), scores = x); for (d in seq_len(min(3, length(x) - 1))) {
        score <- drop(marginal %*% curves[, d]); test <- t.test(score); key <- paste(name, c("linear", "quadratic", "cubic")[d], sep = "|")
        row("trend.estimate", key, mean(score)); row("trend.t", key, test$statistic[[1]]); row("trend.p", key, test$p.value, "tail")
      }
    }
    pairs <- combn(levels, 2); keys <- paste(name, pairs[1, ], pairs[2, ], sep = "|"); p <- c()
    for (j in seq_along(keys)) {
      d <- marginal[, pairs[1, j]] - marginal[, pairs[2, j]]; test <- t.test(d, conf.level = confidence); p[j] <- test$p.value
      row("pair.diff", keys[j], mean(d)); row("pair.t", keys[j], test$statistic[[1]]); row("pair.p", keys[j], p[j], "tail"); row("pair.ci.lower", keys[j], test$conf.int[1])
      row("pair.ci.upper", keys[j], test$conf.int[2]); row("pair.dz", keys[j], mean(d) / sd(d))
    }
    rows("pair.p.holm", keys, p.adjust(p, "holm"), "tail")
  }
}
