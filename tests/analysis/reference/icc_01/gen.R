source("../R/case.R"); source("../R/icc.R")
# The ratings were drawn once; the table is read, not made.
data <- read.csv("data.csv")
write_case("icc", "every target rated once by every rater", "data.csv", c(conf = "0.95"))
icc_results(data, 0.95)
write_results()
