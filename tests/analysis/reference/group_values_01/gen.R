source("../R/case.R"); source("../R/group_values.R")
set.seed(31); groups <- c("trained", "control")
data <- data.frame(subject = paste0("P", 1:11), group = rep(groups, c(5, 6)))
data$value <- signif(exp(rnorm(11, ifelse(data$group == "trained", -.5, 0), .4)), 4)
write_table(data, "subjects.csv")
write_case("group_values", "positive numbers, compared by the ratio of their geometric means", "subjects.csv",
           c(groups = json_list(groups), scale = json_text("ratio")))
group_values_results(data, groups, TRUE, .95)
write_results()
