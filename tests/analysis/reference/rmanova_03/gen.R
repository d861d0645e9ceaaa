source("../R/case.R"); source("../R/rmanova.R")
# Type 2 with unequal groups; fewer participants than contrasts, so that Mauchly's W is not defined.
set.seed(43); within <- list(level = c("a", "b", "c", "d", "e", "f")); between <- list(sex = c("F", "M")); people <- rep(between$sex, c(2, 4))
data <- do.call(rbind, lapply(1:6, function(i) data.frame(subject = paste0("P", i), sex = people[i], level = within$level, y = round(rnorm(1) + 1:6 * (.1 + .1 * (people[i] == "M")) + rnorm(6, 0, .3), 3))))
write_table(data, "data.csv")
write_case("rmanova", "type 2, fewer participants than contrasts", "data.csv",
           c(within = "{ \"level\": [\"a\", \"b\", \"c\", \"d\", \"e\", \"f\"] }", between = "{ \"sex\": [\"F\", \"M\"] }", type = "2", conf = "0.95"))
rmanova_results(data, within, between, type = 2)
write_results()
