source("../R/case.R"); source("../R/recognition.R"); source("../R/power.R")
plan <- function(called, test, size, error = .05, ...) {
  row <- data.frame(id = called, kind = test, n = size, k = NA, p0 = NA, p1 = NA, alpha = error, theta = NA, d = NA, f = NA, rho = NA, eps = NA, probs = NA)
  given <- list(...); row[names(given)] <- given; row
}
data <- rbind(
  plan("one_of_four", "binom_greater", 24, p0 = .25, p1 = .5), plan("too_few", "binom_greater", 3, p0 = .5, p1 = .9), plan("pair", "binom_two", 31, .1, p0 = .5, p1 = .7),
  plan("four_ways", "chisq_uniform_exact", 12, k = 4, probs = "0.55;0.25;0.15;0.05"), plan("weak_match", "matching_mallows", 8, k = 5, theta = .4),
  plan("avoids", "matching_mallows", 6, k = 3, theta = -.3), plan("knows_one", "matching_known", 7, k = 5, d = 1), plan("knows_all", "matching_known", 2, k = 4, d = 4),
  plan("small_t", "paired_t", 6, d = 1.1), plan("large_t", "paired_t", 45, .01, d = .45), plan("three_levels", "rm_anova", 9, k = 3, f = .35, rho = .4, eps = .8),
  plan("uneven", "fisher_two", 9, k = 6, p0 = .25, p1 = .8), plan("of_eight", "mafc_dprime", 16, k = 8, d = .9), plan("pooled", "betabinom_pool", 9, k = 4, p0 = .25, p1 = .25, rho = .3))
write_table(data, "scenarios.csv")
write_case("power", "a plan of every kind", "scenarios.csv")
power_results(data)
write_results()
