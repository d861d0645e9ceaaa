source("../R/case.R"); source("../R/roc.R")
# The counts were drawn once; the table is read, not made.
data <- read.csv("data.csv")
write_case("roc", "rating ROC", "data.csv", c(conf = "0.95"))
roc_results(data, 0.95)
write_results()
