source("../R/case.R"); source("../R/paired.R")
set.seed(62)
items <- c("a", "b", "c", "d")
data <- data.frame(subject = rep(c("x", "y", "z"), each = 24), first = sample(items, 72, TRUE)); data$second <- sapply(data$first, function(i) sample(setdiff(items, i), 1))
data <- data[!(data$first %in% c("a", "d") & data$second %in% c("a", "d")), ]
data$winner <- ifelse(runif(nrow(data)) < .25, "tie", ifelse(runif(nrow(data)) < ifelse(data$first < data$second, .7, .45), data$first, data$second)); data$winner[c(2, 9, 30)] <- NA
write_table(data, "pairs.csv")
write_case("paired", "ties, judgements not made, one pair never compared, unequal numbers", "pairs.csv", c(items = json_list(items), conf = "0.9"))
paired_results(data, items, .9)
write_results()
