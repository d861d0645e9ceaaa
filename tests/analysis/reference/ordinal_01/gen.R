source("../R/case.R"); source("../R/ordinal.R")
set.seed(11)
items <- c("flat", "wave", "pile", "map")
data <- ordinal_data(12, items, c(0, 0.8, 1.5, -0.6), 2, 5, 2.2, 0.9)
write_table(data, "ratings.csv")
write_case("ordinal", "four items rated twice by each participant, five categories", "ratings.csv",
           c(items = json_list(items)))
ordinal_results(read_table("ratings.csv"), items)
write_results()
