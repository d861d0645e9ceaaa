# The RMSE of thresholds from the same observers and procedures as recovery.cpp, by other code: all tracks at once as vectors, R's random
# numbers, and the greatest likelihood on a grid of α and β. Usage: Rscript independent.R OBSERVERS > independent.tsv
observers <- as.integer(commandArgs(TRUE)[1]); set.seed(71)
grid <- seq(-1, 1, 0.025); trials <- 240; after <- c(40, 60, 80, 120, 240); guess <- 0.5; assumed <- 0.02
psi <- function(x, a, b, lapse) guess + (1 - guess - lapse) * -expm1(-10^(b * (x - a)))
place <- function(p, a, b, lapse) a + log10(-log1p(-(p - guess) / (1 - guess - lapse))) / b

# Steps in levels of the grid, by the number of reversals; the last one continues.
methods <- list(
  `1u2d` = list(down = 2, up_steps = c(8, 4, 4, 4, 2), down_steps = c(8, 4, 4, 4, 2), target = 0.5^(1 / 2)),
  `1u3d` = list(down = 3, up_steps = c(8, 4, 4, 4, 2), down_steps = c(8, 4, 4, 4, 2), target = 0.5^(1 / 3)),
  `1u3d_unequal` = list(down = 3, up_steps = c(8, 4), down_steps = c(6, 3), target = (1 / 1.75)^(1 / 3)),
  weighted_75 = list(down = 1, up_steps = 3 * c(4, 4, 4, 4, 2), down_steps = c(4, 4, 4, 4, 2), target = 0.75),
  constant = list(levels = c(25, 33, 41, 49, 57)))

# Matrices observers × trials: index of the level, correct or not.
tracks_of <- function(method, a, beta, lapse) {
  level <- correct <- matrix(0L, observers, trials)
  if (!is.null(method$levels)) {
    for (block in seq(1, trials, 5)) level[, block:(block + 4)] <- t(replicate(observers, sample(method$levels)))
    correct[] <- runif(observers * trials) < psi(grid[level], a, beta, lapse)
    return(list(level = level, correct = correct))
  }
  at <- rep(65L, observers); run <- integer(observers); reversals <- integer(observers); direction <- integer(observers)
  step <- function(steps, n) steps[pmin(n + 1, length(steps))]
  for (trial in 1:trials) {
    yes <- runif(observers) < psi(grid[at], a, beta, lapse); level[, trial] <- at; correct[, trial] <- yes
    run <- ifelse(yes, run + 1L, 0L); move <- ifelse(!yes, 1L, ifelse(run == method$down, -1L, 0L)); run[move != 0] <- 0L
    turned <- move != 0 & direction != 0 & move != direction; reversals <- reversals + turned; direction[move != 0] <- move[move != 0]
    at <- at + ifelse(move > 0, step(method$up_steps, reversals), ifelse(move < 0, -step(method$down_steps, reversals), 0))
    at <- as.integer(pmin(81, pmax(1, at)))
  }
  list(level = level, correct = correct)
}
parameters <- expand.grid(a = seq(-2.5, 2.5, 0.02), b = exp(seq(0, log(8), length.out = 21)))
log_p <- sapply(grid, function(x) log(psi(x, parameters$a, parameters$b, assumed)))
log_q <- sapply(grid, function(x) log1p(-psi(x, parameters$a, parameters$b, assumed)))
fitted_of <- function(track, n) {
  hits <- misses <- matrix(0, observers, 81); who <- rep(seq_len(observers), n)
  level <- as.vector(track$level[, 1:n]); yes <- as.vector(track$correct[, 1:n]) == 1
  counts <- function(some) matrix(tabulate(who[some] + observers * (level[some] - 1L), observers * 81L), observers)
  hits <- counts(yes); misses <- counts(!yes); seen <- colSums(hits + misses) > 0
  likelihood <- tcrossprod(hits[, seen], log_p[, seen]) + tcrossprod(misses[, seen], log_q[, seen])
  best <- max.col(likelihood, "first"); p <- pmin(1 - assumed, pmax(guess, rowSums(hits) / n))
  constant <- rowSums(hits) * log(p) + rowSums(misses) * log1p(-p)
  ifelse(likelihood[cbind(seq_len(observers), best)] > constant + 1e-6, best, NA)  # NA: no threshold
}
cat("procedure\testimate\tbeta\tlapse\ttrials\tobservers\trmse_log10\n")
for (name in names(methods)) for (beta in c(1.3, 2, 3.5)) for (lapse in c(0, 0.02, 0.05)) {
  method <- methods[[name]]; a <- runif(observers, -0.3, 0.3); track <- tracks_of(method, a, beta, lapse)
  for (n in after) {
    best <- parameters[fitted_of(track, n), ]
    questions <- if (is.null(method$target)) c(fit_75 = 0.75) else c(fit_75 = 0.75, fit_target = method$target)
    for (question in names(questions)) {
      p <- questions[[question]]; estimate <- pmin(1, pmax(-1, place(p, best$a, best$b, assumed)))
      rmse <- sqrt(mean((estimate - place(p, a, beta, lapse))^2, na.rm = TRUE))
      cat(name, question, beta, lapse, n, observers, sprintf("%.6f", rmse), sep = "\t"); cat("\n")
    }
  }
}
