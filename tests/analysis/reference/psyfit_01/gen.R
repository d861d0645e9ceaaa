source("../R/case.R"); source("../R/differences.R"); source("../R/psyfit.R")
set.seed(51); x <- seq(-.8, .8, .4); n <- 24
data <- data.frame(condition = "fine", x = x, n = n, k = rbinom(5, n, 1 / 3 + (2 / 3 - .02) * shapes$gumbel$F(x, -.1, 1.4)))
draws <- t(replicate(8, rbinom(5, n, data$k / n))); draws[8, ] <- n; colnames(draws) <- paste0("k", 1:5)
write_table(data, "blocks.csv"); write_table(data.frame(b = 1:8, draws), "boot.csv"); o <- list(shape = "gumbel", gamma = 1 / 3, lambda = .02, lambda_max = .06, pt = .7)
write_case("psyfit", "gumbel, one of three, resamples of which one is all right", c("blocks.csv", "boot.csv"),
           c(shape = json_text("gumbel"), gamma = sprintf("%.17g", 1 / 3), lambda = "0.02", lambda_max = "0.06", pt = "0.7", conf = "0.95"))
psyfit_results(data, o, resamples = draws)
write_results()
