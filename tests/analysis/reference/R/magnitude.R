# Magnitude estimation: regressions by lm, one participant at a time; Fieller's ends by root finding; standard errors of peaks by
# differences.
peak_of <- function(curve) if (curve[3] < 0) -curve[2] / (2 * curve[3]) else NA
slopes_of <- function(f, x, h = 1e-5) sapply(seq_along(x), function(i) { e <- replace(numeric(length(x)), i, h * max(1, abs(x[i]))); (f(x + e) - f(x - e)) / (2 * sum(e)) })
spread_of <- function(f, at, covariance) { g <- slopes_of(f, at); sqrt(drop(t(g) %*% covariance %*% g)) }
t_rows <- function(prefix, key, x) {
  se <- sd(x) / sqrt(length(x)); df <- length(x) - 1
  row(paste0(prefix, ".t"), key, mean(x) / se); row(paste0(prefix, ".p"), key, 2 * pt(-abs(mean(x) / se), df), "tail")
}

# Where |b + 2cx| = t sqrt(variance of it): ends of an interval around the peak, or NA where there are none.
fieller <- function(m, v, t) {
  gap <- function(x) { d <- c(0, 1, 2 * x); (sum(d * m))^2 - t^2 * drop(t(d) %*% v %*% d) }
  if (4 * (m[3]^2 - t^2 * v[3, 3]) <= 0) return(NULL)
  peak <- peak_of(m); far <- function(side) { step <- 1e-3; while (gap(peak + side * step) < 0) step <- 1.5 * step; peak + side * step }
  c(uniroot(gap, c(far(-1), peak), tol = 1e-15)$root, uniroot(gap, c(peak, far(1)), tol = 1e-15)$root)
}

magnitude_results <- function(data, zero_rule, standard = NULL, modulus = NULL, confidence = .95, resamples = NULL) {
  data$subject <- as.character(data$subject)
  row("n.missing", "", sum(is.na(data$estimate)), "count"); data <- data[!is.na(data$estimate), ]
  row("n.zero", "", sum(data$estimate == 0), "count")
  if (zero_rule == "exclude") data <- data[data$estimate > 0, ]
  else for (i in which(data$estimate == 0)) { own <- data$estimate[data$subject == data$subject[i]]; data$estimate[i] <- min(own[own > 0]) / 2 }
  people <- unique(data$subject); probes <- unique(data$probe); spacings <- sort(unique(data$spacing)); x <- log10(spacings)
  cells <- aggregate(log10(estimate) ~ subject + probe + spacing, data, mean); names(cells)[4] <- "l"
  have <- table(factor(cells$subject, people)); whole <- have == length(probes) * length(spacings)
  row("subjects.incomplete", "", if (all(whole)) "none" else paste(people[!whole], collapse = ";"))
  people <- people[whole]; cells <- cells[cells$subject %in% people, ]; n <- length(people); row("n.subjects", "", n, "count")
  own <- tapply(cells$l, cells$subject, mean)[people]; rows("subject.geomean", people, 10^own)
  cells <- cells[order(match(cells$subject, people), match(cells$probe, probes), cells$spacing), ]
  if (is.null(standard)) { row("grand.geomean", "", 10^mean(own)); cells$l <- cells$l - own[cells$subject] + mean(own) }
  else { at <- cells[cells$spacing == standard, ]; cells$l <- cells$l - tapply(at$l, at$subject, mean)[cells$subject] + log10(modulus) }
  rows("norm.estimate", paste(cells$subject, cells$probe, cells$spacing, sep = "|"), 10^cells$l)
  t <- qt(0.5 + confidence / 2, n - 1); many <- length(probes) * length(spacings)
  for (p in probes) for (s in spacings) {
    y <- cells$l[cells$probe == p & cells$spacing == s]; half <- t * sqrt(var(y) / n); key <- paste(p, s, sep = "|")
    row("geomean", key, 10^mean(y)); row("geomean.ci.lower", key, 10^(mean(y) - half)); row("geomean.ci.upper", key, 10^(mean(y) + half))
    if (is.null(standard)) row("geomean.ci.upper.morey", key, 10^(mean(y) + half * sqrt(many / (many - 1))))
  }
  all_curves <- list()
  for (p in probes) {
    y <- sapply(people, function(s) cells$l[cells$probe == p & cells$subject == s]); means <- rowMeans(y)
    lines <- t(apply(y, 2, function(one) coef(lm(one ~ x)))); curves <- t(apply(y, 2, function(one) coef(lm(one ~ x + I(x^2))))); all_curves[[as.character(p)]] <- curves
    slope <- lines[, 2]; rows("exponent.subject", paste(p, people, sep = "|"), slope); row("exponent.mean", p, mean(slope))
    se <- sd(slope) / sqrt(n); row("exponent.se", p, se); row("exponent.ci.lower", p, mean(slope) - t * se); row("exponent.ci.upper", p, mean(slope) + t * se)
    t_rows("exponent", p, slope); row("intercept.mean", p, mean(lines[, 1]))
    line <- lm(means ~ x); curve <- lm(means ~ x + I(x^2)); total <- sum((means - mean(means))^2)
    row("pooled.linear.slope", p, coef(line)[[2]]); row("pooled.linear.r2", p, 1 - deviance(line) / total); row("pooled.linear.se", p, sqrt(vcov(line)[2, 2]))
    m <- colMeans(curves); v <- cov(curves) / n; rows("quad.coef", paste(p, c("a", "b", "c"), sep = "|"), m)
    for (i in 1:3) for (j in 1:3) row("quad.cov", paste(p, letters[i], letters[j], sep = "|"), v[i, j])
    row("pooled.quad.r2", p, 1 - deviance(curve) / total)
    f <- (deviance(line) - deviance(curve)) / (deviance(curve) / df.residual(curve)); row("pooled.quad.vs.linear.F", p, f, "optimum")
    row("pooled.quad.vs.linear.p", p, pf(f, 1, df.residual(curve), lower.tail = FALSE), "optimum")
    t_rows("quad.c", p, curves[, 3])
    ends <- range(x)
    for (i in 1:2) {
      own_slope <- curves[, 2] + 2 * ends[i] * curves[, 3]; name <- c("low", "high")[i]; te <- mean(own_slope) / (sd(own_slope) / sqrt(n))
      row(paste0("invU.slope.", name), p, mean(own_slope)); row(paste0("invU.t.", name), p, te); row(paste0("invU.p.", name), p, pt(c(-te, te)[i], n - 1), "tail")
    }
    peak <- unname(peak_of(m)); inside <- !is.na(peak) && peak >= ends[1] && peak <= ends[2]
    row("peak.status", p, if (is.na(peak)) "no_maximum" else if (inside) "ok" else "outside_range")
    if (!is.na(peak)) { set <- fieller(m, v, t); row("peak.fieller", p, if (is.null(set)) "unbounded" else "bounded") }
    if (inside) {
      se <- spread_of(peak_of, m, v); row("peak.log10", p, peak); row("peak", p, 10^peak); row("peak.se.log10", p, se, "optimum")
      row("peak.delta.lower", p, 10^(peak - t * se), "optimum"); row("peak.delta.upper", p, 10^(peak + t * se), "optimum")
      row("peak.height", p, 10^(m[[1]] + m[[2]] * peak + m[[3]] * peak^2))
      if (!is.null(set)) { row("peak.fieller.lower", p, 10^set[1]); row("peak.fieller.upper", p, 10^set[2]) }
      row("peak.se.log10.pooledOLS", p, spread_of(peak_of, coef(curve), vcov(curve)), "optimum")
    }
    peaks <- apply(curves, 1, peak_of); row("peak.subjects.concave", p, sum(!is.na(peaks)), "count")
    tested <- peaks[!is.na(peaks) & peaks >= ends[1] & peaks <= ends[2]]; row("peak.subjects.inrange", p, length(tested), "count")
    if (length(tested)) row("peak.subjects.median", p, 10^median(tested))
    if (inside && !is.null(resamples)) {
      again <- apply(resamples, 1, function(who) peak_of(colMeans(curves[who, ]))); again <- again[!is.na(again)]
      low <- (1 - confidence) / 2; ends_of <- quantile(again, c(low, 1 - low)); row("boot.valid", p, length(again), "count")
      row("boot.perc.lower", p, 10^ends_of[[1]]); row("boot.perc.upper", p, 10^ends_of[[2]]); row("boot.se.log10", p, sd(again))
      rest <- sapply(1:n, function(i) peak_of(colMeans(curves[-i, ])))
      if (!anyNA(rest)) {
        z <- qnorm(mean(again < peak - 1e-12) + mean(abs(again - peak) <= 1e-12) / 2); lean <- mean(rest) - rest; a <- sum(lean^3) / (6 * sum(lean^2)^1.5)
        place <- sapply(qnorm(c(low, 1 - low)), function(q) pnorm(z + (z + q) / (1 - a * (z + q)))); ends_of <- quantile(again, place)
        row("boot.bca.z0", p, z); row("boot.bca.a", p, a, "optimum"); row("boot.bca.lower", p, 10^ends_of[[1]], "optimum"); row("boot.bca.upper", p, 10^ends_of[[2]], "optimum")
      }
    }
  }
  if (length(probes) > 1) for (i in seq_len(ncol(combn(probes, 2)))) {
    two <- as.character(combn(probes, 2)[, i]); joint <- cbind(all_curves[[two[1]]], all_curves[[two[2]]]); m <- colMeans(joint)
    if (m[3] >= 0 || m[6] >= 0) next
    shift <- function(m) unname(peak_of(m[1:3]) - peak_of(m[4:6])); d <- shift(m); se <- spread_of(shift, m, cov(joint) / n); key <- paste(two, collapse = "|")
    row("peakratio", key, 10^d); row("peakratio.se.log10", key, se, "optimum"); row("peakratio.t", key, d / se, "optimum")
    row("peakratio.p", key, 2 * pt(-abs(d / se), n - 1), "optimum"); row("peakratio.lower", key, 10^(d - t * se), "optimum"); row("peakratio.upper", key, 10^(d + t * se), "optimum")
  }
}
