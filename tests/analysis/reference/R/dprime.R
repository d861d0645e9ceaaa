# Sensitivity and bias. Roots by uniroot, polished by Newton's method with numerical derivatives; psyphy's tables are a check where it is
# installed. Designs: yesno, 2afc (first or second), mafc, samediff (yes = "different"), abx, oddity.
root_of <- function(f, low, high) {
  x <- uniroot(f, c(low, high), tol = 1e-15)$root
  for (i in 1:4) {
    slope <- (f(x + 1e-6) - f(x - 1e-6)) / 2e-6
    if (is.finite(slope) && slope != 0) x <- x - f(x) / slope
  }
  x
}
integral <- function(f, low, high) integrate(f, low, high, rel.tol = 1e-13, abs.tol = 0, subdivisions = 5000)$value
# The largest of m impressions [Hacker 1979]; the one farthest from the mean of three [Frijters 1979].
pc_mafc <- function(d, m) integral(function(x) dnorm(x - d) * pnorm(x)^(m - 1), d - 14, d + 14)
pc_oddity <- function(d)
  2 * integral(function(z) (pnorm(-z * sqrt(3) + d * sqrt(2 / 3)) + pnorm(-z * sqrt(3) - d * sqrt(2 / 3))) * dnorm(z), 0, Inf)

choice_results <- function(r, confidence) {
  id <- r$id; n <- r$signal_n; pc <- r$signal_yes / n
  row("pc", id, pc)
  is_oddity <- r$design == "oddity"
  correct_at <- if (is_oddity) pc_oddity else function(d) pc_mafc(d, r$m)
  inverse <- function(p) {
    if (p >= 1) return(Inf)
    if (is_oddity && p <= 1 / 3) return(0)
    if (p <= 0) return(-Inf)
    root_of(function(d) correct_at(d) - p, if (is_oddity) 1e-9 else -12, 14)
  }
  ends <- wilson(r$signal_yes, n, confidence)
  d <- inverse(pc)
  row("dprime", id, d, if (is.finite(d) && d != 0) "optimum" else "count")
  row("dprime.lower", id, inverse(ends[1]), "optimum")
  row("dprime.upper", id, inverse(ends[2]), "optimum")
  if (is.finite(d) && d > 0) {
    slope <- (correct_at(d + 1e-5) - correct_at(d - 1e-5)) / 2e-5
    row("dprime.se", id, sqrt(pc * (1 - pc) / n) / slope, "curvature")
  }
}

rate_results <- function(r, confidence) {
  id <- r$id; n <- c(r$signal_n, r$noise_n); yes <- c(r$signal_yes, r$noise_yes)
  observed <- yes / n
  corrected <- (yes + 0.5) / (n + 1)  # [Hautus 1995]
  row("hit", id, observed[1]); row("fa", id, observed[2])
  row("hit.loglinear", id, corrected[1]); row("fa.loglinear", id, corrected[2])
  is_extreme <- any(yes == 0 | yes == n)
  if (is_extreme) row("dprime", id, NA_real_)
  for (ending in c("", ".loglinear")) {
    if (ending == "" && is_extreme) next
    p <- if (ending == "") observed else corrected
    trials <- if (ending == "") n else n + 1
    put <- function(quantity, value, known = "formula") row(paste0(quantity, ending), id, value, known)
    z <- qnorm(p); difference <- z[1] - z[2]; criterion <- -sum(z) / 2
    if (r$design == "yesno") {
      error <- sqrt(sum(p * (1 - p) / (trials * dnorm(z)^2)))  # [Gourevitch 1967]
      reach <- qnorm(0.5 + confidence / 2) * error
      put("dprime", difference); put("criterion", criterion); put("lnbeta", difference * criterion)
      put("dprime.se", error); put("dprime.lower", difference - reach); put("dprime.upper", difference + reach)
    }
    if (r$design == "2afc") { put("dprime", difference / sqrt(2)); put("criterion", criterion) }
    unbiased <- pnorm(difference / 2)
    if (r$design == "samediff") {
      k <- -sqrt(2) * qnorm(p[2] / 2)
      d <- if (p[1] <= p[2]) 0 else
        root_of(function(d) pnorm((d - k) / sqrt(2)) + pnorm((-d - k) / sqrt(2)) - p[1], 0, 20)
      put("dprime.diff", d, if (d == 0) "count" else "optimum"); put("k.diff", k, "tail")
      put("dprime.io", if (unbiased <= 0.5) 0 else 2 * qnorm((1 + sqrt(2 * unbiased - 1)) / 2),
          if (unbiased <= 0.5) "count" else "formula")
    }
    if (r$design == "abx") for (rule in c("diff", "io")) {
      s <- if (rule == "diff") sqrt(6) else 2
      d <- if (unbiased <= 0.5) 0 else
        root_of(function(d) pnorm(d / sqrt(2)) * pnorm(d / s) + pnorm(-d / sqrt(2)) * pnorm(-d / s) - unbiased, 0, 25)
      put(paste0("dprime.", rule), d, if (d == 0) "count" else "optimum")
    }
  }
}

dprime_results <- function(data, confidence) for (i in seq_len(nrow(data)))
  (if (data$design[i] %in% c("mafc", "oddity")) choice_results else rate_results)(data[i, ], confidence)
