source("../R/case.R"); source("../R/ranking.R")
set.seed(71)
items <- c("map", "wave", "pile", "felt", "flat"); worth <- c(1, 2, .6, 1.4, .4)
one <- function(trial) { order <- sample(5, 5, FALSE, worth); data.frame(trial, subject = paste0("P", (trial + 1) %/% 2), item = items, rank = match(1:5, order)) }
data <- do.call(rbind, lapply(1:14, one))
write_table(data, "rankings.csv")
write_case("ranking", "all five ranked, two trials by each of seven", "rankings.csv", c(items = json_list(items)))
ranking_results(data, items)
write_results()
