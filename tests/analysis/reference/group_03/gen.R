source("../R/case.R"); source("../R/differences.R"); source("../R/group.R")
# Everything right in one group: the odds are not finite.
data <- data.frame(subject = paste0("P", 1:8), group = rep(c("A", "B"), c(3, 5)), correct = c(6, 6, 6, 4, 5, 3, 6, 4), trials = 6)
write_table(data, "subjects.csv")
write_case("group", "all right in one group", "subjects.csv", c(groups = json_list(c("A", "B")), conf = "0.95"))
group_results(data, c("A", "B"), .95)
write_results()
