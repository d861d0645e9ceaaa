source("../R/case.R"); source("../R/equivalence.R")
# The pairs were drawn once; the table is read, not made.
data <- read.csv("data.csv")
write_case("equivalence", "pairs of participants, bounds of 0.8 on either side", "data.csv", c(lower = "-0.8", upper = "0.8", alpha = "0.05"))
equivalence_results(data, -0.8, 0.8, 0.05)
write_results()
