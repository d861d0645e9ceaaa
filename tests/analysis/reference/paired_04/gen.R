source("../R/case.R"); source("../R/paired.R")
data <- data.frame(subject = rep(c("x", "y", "z", "w"), 3), first = c("old", "new"), second = c("new", "old"), winner = c("new", "new", "tie", "old", "new", "new", "old", "new", "new", "old", "new", "tie"))
data$first[5] <- "new"; data$second[5] <- "old"
write_table(data, "pairs.csv")
write_case("paired", "two items", "pairs.csv", c(items = json_list(c("new", "old")), conf = "0.95"))
paired_results(data, c("new", "old"), .95)
write_results()
