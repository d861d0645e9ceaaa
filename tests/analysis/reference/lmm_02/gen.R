source("../R/case.R"); source("../R/lmm.R")
# Every participant once under each condition: a paired design, whose degrees of freedom are whole numbers.
set.seed(62); data <- expand.grid(condition = c("a", "b", "c"), subject = paste0("S", 1:8))
data$y <- round(10 + rnorm(8, 0, 2)[as.integer(data$subject)] + c(0, 1, .5)[as.integer(data$condition)] + rnorm(24), 2)
data <- data.frame(subject = as.character(data$subject), condition = as.character(data$condition), y = data$y)
write_table(data, "data.csv")
write_case("lmm", "a balanced design within participants", "data.csv", c(fixed = "{ \"condition\": [\"a\", \"b\", \"c\"] }"))
lmm_results(data, "condition")
write_results()
