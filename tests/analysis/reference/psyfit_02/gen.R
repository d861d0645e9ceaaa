source("../R/case.R"); source("../R/differences.R"); source("../R/psyfit.R")
# Both rates free in one condition with lapses and false alarms; in the other the lapses end at their bound.
data <- rbind(data.frame(condition = "slow", x = c(-3, -2, -1, 0, 1, 2, 3), n = 40, k = c(4, 3, 6, 19, 35, 38, 38)), data.frame(condition = "quick", x = c(-2, -1, 0, 1, 2), n = 15, k = c(2, 2, 7, 12, 15)))
write_table(data, "blocks.csv"); o <- list(shape = "logistic", gamma = "free", lambda = "free", lambda_max = .1, pt = .5)
write_case("psyfit", "logistic, both rates free", "blocks.csv", c(shape = json_text("logistic"), gamma = json_text("free"), lambda = json_text("free"), lambda_max = "0.1", pt = "0.5", conf = "0.9"))
psyfit_results(data, o, .9)
write_results()
