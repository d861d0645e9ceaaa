source("../R/case.R"); source("../R/ordinal.R")
set.seed(23)
items <- c("new", "old", "worn")
data <- ordinal_data(9, items, c(0, -1.1, 2.4), 3, 7, 3.5, 1.6)
# A tenth of the ratings is missing, and a participant has rated two items only; the categories are not whole numbers.
data$score[seq(4, nrow(data), by = 10)] <- NA
data <- data[!(data$subject == "p3" & data$item == "worn"), ]
data$score <- data$score / 2
write_table(data, "ratings.csv")
write_case("ordinal", "three items with missing ratings, half steps", "ratings.csv",
           c(items = json_list(items)))
ordinal_results(read_table("ratings.csv"), items)
write_results()
