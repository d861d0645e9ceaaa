source("../R/case.R"); source("../R/group_values.R")
set.seed(34); groups <- c("trained", "untrained")
# Assigned in permuted blocks of 4 and 2; the last block ended after three participants.
data <- data.frame(subject = paste0("P", 1:13), block = rep(c("1", "2", "3", "4"), c(4, 2, 4, 3)),
                   group = groups[c(1, 2, 2, 1, 2, 1, 1, 1, 2, 2, 1, 2, 1)])
data$value <- round(exp(rnorm(13, -0.5 + 0.7 * (data$group == "trained") + 0.3 * as.integer(data$block), 0.5)), 3)
data <- data[, c("subject", "group", "block", "value")]; write_table(data, "subjects.csv")
write_case("group_values", "logarithms of numbers of two groups that were assigned in permuted blocks", "subjects.csv",
           c(groups = json_list(groups), scale = "\"ratio\""))
group_values_results(data, groups, TRUE, .95)
write_results()
