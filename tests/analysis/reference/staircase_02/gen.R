source("../R/case.R"); source("../R/staircase.R")
# Another start and weight; missing responses, a track without a reversal. The responses were drawn once; the table is read, not made.
rules <- list(
  up2 = list(start = 20, n_down = 2, n_up = 1, step = c(4, 2, 1), scale = "linear", min = 0, max = 40, discard = 2),
  up3 = list(start = 1.6, n_down = 3, n_up = 1, step = c(0.2, 0.1, 0.05), scale = "log10", min = 0.01, max = 10, discard = 4, even = TRUE),
  kaern = list(start = 15, n_down = 1, n_up = 1, step = 1, step_up_ratio = 3, scale = "db", min = 0.5, max = 60, discard = 0),
  flat = list(start = 5, n_down = 1, n_up = 1, step = 1, scale = "linear", min = 4, max = 6, discard = 3))
write_staircase_case("up-down rules, clipping, missing, no reversal", rules)
staircase_results(read.csv("tracks.csv"), rules)
write_results()
