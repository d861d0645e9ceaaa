source("../R/case.R"); source("../R/differences.R"); source("../R/psyfit.R")
block <- function(condition, x, n, k) data.frame(condition = condition, x = x, n = n, k = k)
data <- rbind(block("step", c(3, 1, 2, 4), 5, c(5, 0, 0, 5)), block("right", 1:2, 4, 4), block("wrong", 1:2, 4, 0), block("single", c(2, 2), 6, c(2, 3)), block("nearly", 1:4, 8, c(0, 5, 8, 8)),
              block("empty", 1:3, 0, 0), block("steep", 1:6, c(9, 9, 0, 9, 9, 9), c(0, 1, 0, 8, 9, 9)))
write_table(data, "blocks.csv"); o <- list(shape = "normal", gamma = 0, lambda = 0, pt = .5)
write_case("psyfit", "data without a likeliest function, and one with", "blocks.csv", c(shape = json_text("normal"), gamma = "0", lambda = "0", pt = "0.5", conf = "0.95"))
psyfit_results(data, c(o, lambda_max = .1))
write_results()
