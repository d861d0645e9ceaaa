source("../R/case.R"); source("../R/staircase.R")
# Two and three down, a weighted track, one at its lower bound and one that is too short. The responses were drawn once; the table is read, not made.
rules <- list(
  t12 = list(start = 10, n_down = 2, n_up = 1, step = c(2, 1, 0.5), scale = "linear", min = 0, max = 20, discard = 2),
  t13 = list(start = 1, n_down = 3, n_up = 1, step = c(0.2, 0.1, 0.05), scale = "log10", min = 0.01, max = 10, discard = 4, even = TRUE),
  weighted = list(start = 8, n_down = 1, n_up = 1, step = 1, step_up_ratio = 3, scale = "linear", min = 0, max = 30, discard = 2),
  floorhit = list(start = 2, n_down = 1, n_up = 1, step = 1, scale = "linear", min = 1, max = 5, discard = 1),
  short = list(start = 5, n_down = 2, n_up = 1, step = 1, scale = "linear", min = 0, max = 9, discard = 6))
write_staircase_case("1-up-2-down, 1-up-3-down log steps, weighted 75 percent, clipped, too short", rules)
staircase_results(read.csv("tracks.csv"), rules)
write_results()
