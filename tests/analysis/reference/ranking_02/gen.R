source("../R/case.R"); source("../R/ranking.R")
set.seed(73)
items <- c("a", "b", "c", "d")
one <- function(trial) { offered <- sample(items, sample(2:4, 1)); ranked <- sample(length(offered), 1); data.frame(trial, subject = c("x", "y", "z")[1 + trial %% 3], item = offered, rank = ifelse(seq_along(offered) <= ranked, seq_along(offered), NA)) }
data <- do.call(rbind, lapply(1:24, one)); data <- data[sample(nrow(data)), ]; data <- data[order(data$trial), ]
write_table(data, "rankings.csv")
write_case("ranking", "varying sets, varying numbers of ranks", "rankings.csv", c(items = json_list(items)))
ranking_results(data, items)
write_results()
