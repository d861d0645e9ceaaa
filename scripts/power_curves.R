# Power of three protocols of the library without the program: exactly, and by independent simulations.
# Arguments: the number of simulated studies (0 leaves out what is simulated), the seed, and the protocols (default: all).
# Writes a table: protocol, test, participants, power, se.
# The models are those of docs/response-tables.md. scripts/power-figures states the same values to the program.
options(warn = 2)
arguments <- commandArgs(trailingOnly = TRUE)
studies <- as.integer(arguments[1])
seed <- as.integer(arguments[2])
named <- arguments[-(1:2)]
participants <- seq(10, 40, 5)
alpha <- 0.05
lapse <- 0.02

write_row <- function(protocol, test, n, power, se = 0) {
  cat(protocol, test, n, format(power, digits = 8), format(se, digits = 4), sep = "\t")
  cat("\n")
}
write_proportion <- function(protocol, test, n, significant) {
  power <- mean(significant)
  write_row(protocol, test, n, power, sqrt(power * (1 - power) / length(significant)))
}
cat("protocol", "test", "participants", "power", "se", sep = "\t")
cat("\n")

# chapter_recognition: one-sample t test of the proportions of 3 trials among 6 pictures. Every pattern of the participants'
# counts is enumerated; participants differ in d′, textures and pictures do not.
recognition <- function(sensitivity, sensitivity_sd, test = "right", pictures = 6, trials = 3) {
  correct <- function(d) {
    lapse / pictures + (1 - lapse) * integrate(function(x) dnorm(x - d) * pnorm(x)^(pictures - 1), -8, d + 8, rel.tol = 1e-10)$value
  }
  share_of_count <- sapply(0:trials, function(k) {
    of_participant <- function(z) {
      sapply(z, function(one) dnorm(one) * dbinom(k, trials, correct(sensitivity * exp(sensitivity_sd * one))))
    }
    integrate(of_participant, -7, 7, rel.tol = 1e-8)$value
  })
  for (n in participants) {
    power <- 0
    for (one in 0:n) {
      two <- rep(0:(n - one), times = (n - one):0 + 1)
      three <- sequence((n - one):0 + 1) - 1
      none <- n - one - two - three
      sum <- one + 2 * two + 3 * three
      square <- one + 4 * two + 9 * three
      variance <- pmax(square - sum^2 / n, 0) / (n - 1) / trials^2
      t <- (sum / n / trials - 1 / pictures) / sqrt(variance / n)
      # A study in which all counts are equal has no p.
      significant <- variance > 1e-12 & 2 * pt(-abs(t), n - 1) < alpha
      log_chance <- lfactorial(n) - lfactorial(none) - lfactorial(one) - lfactorial(two) - lfactorial(three) +
        none * log(share_of_count[1]) + one * log(share_of_count[2]) + two * log(share_of_count[3]) + three * log(share_of_count[4])
      power <- power + sum(exp(log_chance)[significant])
    }
    write_row("chapter_recognition", test, n, power)
  }
}

# roughness_of_photographs: Friedman test of the means of 6 ratings of 4 items on a line of 1001 points from 0 to 100.
rating <- function(difference, difference_sd, level = 50, level_sd = 10, noise_sd = 15, items = 4, repetitions = 6) {
  place <- (seq_len(items) - 1) / (items - 1) - 0.5
  ratings_of <- function(n) {
    own <- rep(level_sd * rnorm(n), items) + rep(difference * place, each = n) + difference_sd / sqrt(2) * rnorm(n * items)
    sum <- numeric(n * items)
    for (repetition in seq_len(repetitions)) {
      rated <- pmin(pmax(level + own + noise_sd * rnorm(n * items), 0), 100)
      guess <- runif(n * items) < lapse
      rated[guess] <- sample(0:1000, sum(guess), replace = TRUE) / 10
      sum <- sum + round(rated, 1)
    }
    matrix(round(sum, 1), n)
  }
  for (n in participants) {
    write_proportion("roughness_of_photographs", "ratings rough", n,
                     replicate(studies, friedman.test(ratings_of(n))$p.value < alpha))
  }
}

# roughness_diameter: magnitude estimates of 7 spacings with 3 tips, 3 repetitions, in the family of `spacing`, `interaction` and
# `peaks` (three pairs of tips), Holm-corrected. The ANOVA is that of R's anova.mlm, Greenhouse–Geisser-corrected. The peaks of two
# tips are tested by the delta method where both mean parabolas have an interior maximum; otherwise p is 1.
magnitude <- function(exponent, exponent_sd, curvature, curvature_sd, change, change_sd, peak_ratio, peak_ratio_sd,
                      peak_sd = 0.2, ratio_sd = 0.2, level = 1, level_sd = 0.3, noise_sd = 0.1, lapse_sd = 0.3, repetitions = 3) {
  tips <- c("sphere_1mm", "sphere_2mm", "sphere_3mm")
  spacings <- log10(c(0.5, 0.7, 1, 1.4, 2, 2.8, 3.5))
  spacings <- spacings - mean(spacings)
  cells <- expand.grid(spacing = factor(spacings), tip = factor(tips))
  x <- rep(spacings, times = length(tips))
  q <- rep(c(-0.5, 0, 0.5), each = length(spacings))
  pairs <- combn(length(tips), 2)
  tests <- c("spacing", "interaction", paste0("peaks ", tips[pairs[1, ]], "|", tips[pairs[2, ]]))
  log_ratio <- function(n, ratio, sd) (log(ratio) + sd * rnorm(n)) / log(10)

  estimates_of <- function(n) {
    own_level <- level + level_sd * rnorm(n)
    own_peak <- log_ratio(n, 1, peak_sd) + outer(log_ratio(n, peak_ratio, peak_ratio_sd), q)
    from_peak <- matrix(x, n, length(x), byrow = TRUE) - own_peak
    curve <- own_level + outer(exponent + exponent_sd * rnorm(n), x) + outer(change + change_sd * rnorm(n), q * x) +
      outer(log_ratio(n, 1, ratio_sd), q) - (curvature + curvature_sd * rnorm(n)) * from_peak^2
    sum <- 0
    for (repetition in seq_len(repetitions)) {
      logarithm <- curve + noise_sd * rnorm(length(curve))
      guess <- runif(length(curve)) < lapse
      logarithm[guess] <- (own_level[row(curve)] + lapse_sd * rnorm(length(curve)))[guess]
      sum <- sum + log10(signif(10^logarithm, 2))
    }
    sum / repetitions
  }
  peak_p <- function(parabolas, pair) {
    has_maximum <- sapply(parabolas[pair], function(own) {
      slope_at <- function(place) own[, 2] + 2 * own[, 3] * place
      t.test(slope_at(min(spacings)), alternative = "greater")$p.value < alpha &&
        t.test(slope_at(max(spacings)), alternative = "less")$p.value < alpha
    })
    if (!all(has_maximum)) return(1)
    # The peak −b/2c of the mean parabola, and how it changes with the coefficients of each participant.
    linearised <- lapply(parabolas[pair], function(own) {
      b <- mean(own[, 2])
      c <- mean(own[, 3])
      -b / (2 * c) - (own[, 2] - b) / (2 * c) + b * (own[, 3] - c) / (2 * c^2)
    })
    t.test(linearised[[1]], linearised[[2]], paired = TRUE)$p.value
  }
  p_of <- function(y) {
    fit <- lm(y ~ 1)
    anova_p <- function(M, X) anova(fit, M = M, X = X, idata = cells, test = "Spherical")[1, "G-G Pr"]
    parabolas <- lapply(tips, function(tip) t(coef(lm(t(y[, cells$tip == tip]) ~ spacings + I(spacings^2)))))
    c(anova_p(~spacing, ~1), anova_p(~ spacing * tip, ~ spacing + tip), apply(pairs, 2, function(pair) peak_p(parabolas, pair)))
  }
  for (n in participants) {
    significant <- replicate(studies, p.adjust(p_of(estimates_of(n)), "holm") < alpha)
    for (test in c(1, 2, 4)) write_proportion("roughness_diameter", tests[test], n, significant[test, ])
  }
}

computed <- list(
  chapter_recognition = function() {
    recognition(sensitivity = 0.5, sensitivity_sd = 0.5)
    recognition(sensitivity = 0, sensitivity_sd = 0, test = "right, without an effect")
  },
  roughness_of_photographs = function() if (studies > 0) rating(difference = 12, difference_sd = 15),
  roughness_diameter = function() {
    if (studies > 0) {
      magnitude(exponent = 0.05, exponent_sd = 0.2, curvature = 0.4, curvature_sd = 0.2, change = 0.05, change_sd = 0.1,
                peak_ratio = 1.3, peak_ratio_sd = 0.1)
    }
  }
)
for (protocol in if (length(named) > 0) named else names(computed)) {
  set.seed(seed)
  computed[[protocol]]()
}
