source("../R/case.R"); source("../R/bayesian.R")
# Weibull functions of levels in dB. The responses were drawn once; the table is read, not made.
levels <- -40:0
grid <- expand.grid(alpha = -40:0, beta = c(2, 3.5, 5), lambda = c(0, 0.02, 0.04))
hits <- sapply(levels, function(x) 0.5 + (0.5 - grid$lambda) * (1 - exp(-10^(grid$beta * (x - grid$alpha) / 20))))
write_case("questplus", "2AFC Weibull in dB, 41 x 3 x 3 grid", "responses.csv", c(shape = '"weibull_db"',
  gamma = '0.5',
  stim = '[-40, -39, -38, -37, -36, -35, -34, -33, -32, -31, -30, -29, -28, -27, -26, -25, -24, -23, -22, -21, -20, -19, -18, -17, -16, -15, -14, -13, -12, -11, -10, -9, -8, -7, -6, -5, -4, -3, -2, -1, 0]',
  alpha = '[-40, -39, -38, -37, -36, -35, -34, -33, -32, -31, -30, -29, -28, -27, -26, -25, -24, -23, -22, -21, -20, -19, -18, -17, -16, -15, -14, -13, -12, -11, -10, -9, -8, -7, -6, -5, -4, -3, -2, -1, 0]',
  beta = '[2, 3.5, 5]',
  lambda = '[0, 0.02, 0.04]'))
bayesian_results(read.csv("responses.csv")$response, levels, grid, hits, c("alpha", "beta", "lambda"), TRUE)
write_results()
