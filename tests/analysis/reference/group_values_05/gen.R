source("../R/case.R"); source("../R/group_values.R")
set.seed(35); groups <- c("a", "b"); items <- c("wood", "metal", "stone")
# Assigned in permuted blocks of 4; participant 7 has no number for one of the items.
data <- expand.grid(item = items, subject = paste0("P", 1:12))
person <- as.integer(data$subject); data$block <- paste0("B", (person + 3) %/% 4)
data$group <- groups[c(1, 2, 2, 1, 2, 2, 1, 1, 1, 2, 1, 2)][person]
data$value <- round(rnorm(nrow(data), 4 + person / 4 + (data$item == "metal") * (data$group == "b"), 1), 2)
data <- data[, c("subject", "group", "block", "item", "value")]; data$item <- as.character(data$item); data$subject <- as.character(data$subject)
data$value[20] <- NA
write_table(data, "profiles.csv")
write_case("group_values", "profiles of three items, groups assigned in permuted blocks", "profiles.csv", c(groups = json_list(groups)))
group_profiles_results(data, groups, .95)
write_results()
