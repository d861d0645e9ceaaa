source("../R/case.R"); source("../R/learning.R")
# Four participants with 13, 13, 12 and 9 trials, out of order, two without a time: blocks of three trials.
set.seed(23)
trials <- c(P01 = 13, P02 = 13, P03 = 12, P04 = 9)
data <- do.call(rbind, lapply(names(trials), function(subject) {
  trial <- sample(trials[[subject]])
  data.frame(subject, trial, time_s = round(exp(rnorm(1, 0.8, 0.3) - 0.05 * trial + rnorm(length(trial), 0, 0.2)), 4))
}))
data$time_s[c(5, 30)] <- NA
write_table(data, "data.csv")
write_case("learning", "response times over trials, some missing", "data.csv", c(blocks = "5", conf = "0.9"))
learning_of_times(data, 5, 0.9)
write_results()
