source("../R/case.R"); source("../R/dprime.R")
# The counts were drawn once; the table is read, not made.
data <- read.csv("data.csv")
write_case("dprime", "yes-no, 2AFC, mAFC, same-different, ABX, oddity", "data.csv", c(conf = "0.95"))
dprime_results(data, 0.95)
write_results()
