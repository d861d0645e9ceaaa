source("../R/case.R"); source("../R/staircase.R")
# Rules with several up, ratios, no bounds; rows out of order and without a response.
set.seed(61)
rules <- list(
  twoup = list(start = 4, n_down = 1, n_up = 2, step = 1.25, scale = "ratio", discard = 1),
  mixed = list(start = 40, n_down = 3, n_up = 2, step = c(6, 3, 1.5), step_up_ratio = 1.5, scale = "db", min = 1, max = 60, discard = 0, even = TRUE),
  ratio = list(start = 2, n_down = 2, n_up = 1, step = 0.1, step_up_ratio = 1.5, scale = "log10", max = 3, discard = 2))
chance <- c(twoup = .35, mixed = .65, ratio = .75)
data <- do.call(rbind, lapply(names(rules), function(track) data.frame(track, trial = sample(48), response = rbinom(48, 1, chance[[track]]))))
data$response[c(7, 60, 61)] <- NA; data <- data[sample(nrow(data)), ]
write_table(data, "tracks.csv")
write_staircase_case("several up, ratios, rows out of order", rules)
staircase_results(read.csv("tracks.csv"), rules)
write_results()
