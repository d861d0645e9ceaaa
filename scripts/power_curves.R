# Power of two protocols of the library without the program: exactly, and by an independent simulation.
# Arguments: the number of simulated studies (0 leaves out what is simulated), and the seed. Writes a table: protocol, test, participants, power, se.
# The models are those of docs/response-tables.md. scripts/power-figures states the same values to the program.
options(warn = 2)
arguments <- commandArgs(trailingOnly = TRUE)
studies <- as.integer(arguments[1])
set.seed(as.integer(arguments[2]))
participants <- seq(10, 40, 5)
alpha <- 0.05
lapse <- 0.02

write_row <- function(protocol, test, n, power, se = 0) {
  cat(protocol, test, n, format(power, digits = 8), format(se, digits = 4), sep = "\t")
  cat("\n")
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
    significant <- replicate(studies, friedman.test(ratings_of(n))$p.value < alpha)
    power <- mean(significant)
    write_row("roughness_of_photographs", "ratings rough", n, power, sqrt(power * (1 - power) / studies))
  }
}

recognition(sensitivity = 0.5, sensitivity_sd = 0.5)
recognition(sensitivity = 0, sensitivity_sd = 0, test = "right, without an effect")
if (studies > 0) rating(difference = 12, difference_sd = 15)
