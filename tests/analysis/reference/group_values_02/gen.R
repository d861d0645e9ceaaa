source("../R/case.R"); source("../R/group_values.R")
set.seed(32); groups <- c("a", "b")
data <- data.frame(subject = paste0("P", 1:12), group = rep(groups, 6), value = round(rnorm(12, 3, 1), 2))
data$value[c(4, 9)] <- NA
write_table(data, "subjects.csv")
write_case("group_values", "two participants have no number", "subjects.csv", c(groups = json_list(groups)))
group_values_results(data, groups, FALSE, .95)
write_results()
