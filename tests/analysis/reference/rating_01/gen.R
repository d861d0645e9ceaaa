source("../R/case.R"); source("../R/ranking.R")
set.seed(74)
items <- c("map", "wave", "pile", "flat")
data <- expand.grid(item = items, subject = paste0("P", 1:9))[, 2:1]; data$score <- sample(0:5, 36, TRUE) + 2 * (data$item == "wave"); data$score[c(7, 30)] <- NA
write_table(data, "ratings.csv")
write_case("rating", "scores with ties, two participants with a gap", "ratings.csv", c(items = json_list(items)))
rating_results(data, items)
write_results()
