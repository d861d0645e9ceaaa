source("../R/case.R"); source("../R/proportion.R")
data <- data.frame(id = c("half", "none", "all", "one_hit", "one_miss", "nobody", "many", "rare", "equal", "four"),
                   k = c(9, 0, 12, 1, 0, 0, 511, 3, 6, 2), n = c(16, 12, 12, 1, 1, 0, 900, 240, 24, 5),
                   p0 = c(.5, .25, 1 / 6, 1 / 3, .5, .5, .5, 1 / 24, .25, .4), conf = c(.95, .95, .9, .95, .95, .95, .99, .95, .95, .8))
write_table(data, "counts.csv")
write_case("proportion", "counts from nothing to many", "counts.csv")
proportion_results(data)
write_results()
