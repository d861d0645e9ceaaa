source("../R/case.R"); source("../R/paired.R")
set.seed(61)
items <- c("flat", "map", "wave", "pile", "felt"); ability <- c(0, .8, -.4, .3, -.9)
one <- function(subject) { pairs <- t(combn(5, 2)); pairs <- pairs[sample(10), ]; flip <- runif(10) < .5; pairs[flip, ] <- pairs[flip, 2:1]
  p <- plogis(ability[pairs[, 1]] - ability[pairs[, 2]] + .3); data.frame(subject, first = items[pairs[, 1]], second = items[pairs[, 2]], winner = items[ifelse(runif(10) < p, pairs[, 1], pairs[, 2])]) }
data <- do.call(rbind, lapply(sprintf("P%d", 1:6), one))
write_table(data, "pairs.csv")
write_case("paired", "five items, every pair once by six participants", "pairs.csv", c(items = json_list(items), conf = "0.95"))
paired_results(data, items, .95)
write_results()
