source("../R/case.R"); source("../R/learning.R")
# Five participants, eight assignments of four items; one has six.
set.seed(24)
data <- expand.grid(trial = 1:8, subject = c("A", "B", "C", "D", "E"), KEEP.OUT.ATTRS = FALSE)[, 2:1]
data <- data[!(data$subject == "D" & data$trial > 6), ]
data$correct <- rbinom(nrow(data), 4, plogis(-0.5 + 0.2 * data$trial)); data$items <- 4
write_table(data, "data.csv")
write_case("learning", "correctly matched items over trials", "data.csv")
learning_of_proportions(data, 12, 0.95)
write_results()
