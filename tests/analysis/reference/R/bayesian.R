# Bayesian procedures: psi and QUEST+. The probabilities of the parameters are computed from all previous responses before every trial, as
# logarithms, and not by Bayes' theorem from trial to trial; the entropy is that of sums over equal names of the parameters of interest.

entropy_of <- function(p) -sum(ifelse(p > 0, p * log(p), 0))
posterior_after <- function(hits, grid, trials) {
  logs <- rep(0, nrow(grid))
  for (trial in trials) logs <- logs + log(if (trial$response == 1) hits[, trial$place] else 1 - hits[, trial$place])
  p <- exp(logs - max(logs)); p / sum(p)
}
# grid: a row per combination of the parameters; hits: a column per level. Rows of the case, in order.
bayesian_results <- function(responses, levels, grid, hits, of_interest, with_modes) {
  name <- do.call(paste, grid[of_interest]); marginal <- function(p) as.vector(tapply(p, factor(name, unique(name)), sum))
  trials <- list(); gap <- Inf
  for (response in responses) {
    p <- posterior_after(hits, grid, trials); trial <- length(trials) + 1
    expected <- sapply(seq_along(levels), function(place) {
      hit <- sum(p * hits[, place])
      hit * entropy_of(marginal(p * hits[, place] / hit)) + (1 - hit) * entropy_of(marginal(p * (1 - hits[, place]) / (1 - hit)))
    })
    place <- which.min(expected); gap <- min(gap, diff(sort(expected)[1:2]))
    trials[[trial]] <- list(place = place, response = response)
    row("stim", trial, levels[place])
    row("expected.entropy", trial, expected[place], "optimum")
    row("entropy", trial, entropy_of(marginal(posterior_after(hits, grid, trials))), "optimum")
  }
  p <- posterior_after(hits, grid, trials)
  row("min.tie.gap", "", gap, "curvature")
  for (parameter in names(grid)) {
    mean <- sum(p * grid[[parameter]])
    row("posterior.mean", parameter, mean, "optimum")
    row("posterior.sd", parameter, sqrt(sum(p * (grid[[parameter]] - mean)^2)), "optimum")
    if (with_modes) { sums <- tapply(p, grid[[parameter]], sum); row("marginal.mode", parameter, as.numeric(names(sums)[which.max(sums)])) }
  }
  if (!with_modes) return(invisible())
  for (parameter in names(grid)) row("joint.mode", parameter, grid[[parameter]][which.max(p)])
  row("joint.mode.p", "", max(p), "optimum")
}
