source("../R/case.R"); source("../R/differences.R"); source("../R/group.R")
# Participants alike beyond what chance allows: no spread to estimate.
data <- data.frame(subject = paste0("P", 1:10), group = rep(c("A", "B"), each = 5), correct = c(4, 4, 5, 4, 5, 3, 4, 3, 4, 3), trials = 7)
write_table(data, "subjects.csv")
write_case("group", "no spread between participants", "subjects.csv", c(groups = json_list(c("A", "B")), conf = "0.95"))
group_results(data, c("A", "B"), .95)
write_results()
