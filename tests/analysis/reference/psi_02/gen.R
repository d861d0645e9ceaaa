source("../R/case.R"); source("../R/bayesian.R")
# Normal functions of yes and no, only the threshold of interest. The responses were drawn once; the table is read, not made.
levels <- seq(0, 10, 0.625)
grid <- expand.grid(alpha = seq(2, 8, length.out = 19), beta = seq(-1, 0.4, 0.14), gamma = c(0, 0.02, 0.05, 0.1), lambda = c(0, 0.02, 0.05, 0.1))
hits <- sapply(levels, function(x) grid$gamma + (1 - grid$gamma - grid$lambda) * pnorm(10^grid$beta * (x - grid$alpha)))
write_case("psi", "yes-no, only the threshold of interest", "data.csv", c(shape = '"normal"',
  stim = '[0, 0.625, 1.25, 1.875, 2.5, 3.125, 3.75, 4.375, 5, 5.625, 6.25, 6.875, 7.5, 8.125, 8.75, 9.375, 10]',
  alpha = '[2, 2.33333333333333, 2.66666666666667, 3, 3.33333333333333, 3.66666666666667, 4, 4.33333333333333, 4.66666666666667, 5, 5.33333333333333, 5.66666666666667, 6, 6.33333333333333, 6.66666666666667, 7, 7.33333333333333, 7.66666666666667, 8]',
  beta = '[-1, -0.86, -0.72, -0.58, -0.44, -0.3, -0.16, -0.0200000000000001, 0.12, 0.26, 0.4]',
  gamma = '[0, 0.02, 0.05, 0.1]',
  lambda = '[0, 0.02, 0.05, 0.1]',
  nuisance = '["beta", "gamma", "lambda"]'))
bayesian_results(read.csv("data.csv")$response, levels, grid, hits, c("alpha"), FALSE)
write_results()
