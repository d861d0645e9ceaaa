source("../R/case.R"); source("../R/bayesian.R")
# Logistic functions, the lapse rate marginalised. The responses were drawn once; the table is read, not made.
levels <- seq(-2, 2, 0.2)
grid <- expand.grid(alpha = seq(-1.5, 1.5, 0.125), beta = seq(-0.5, 1, 0.1), gamma = 0.5, lambda = seq(0, 0.1, 0.02))
hits <- sapply(levels, function(x) grid$gamma + (1 - grid$gamma - grid$lambda) * plogis(10^grid$beta * (x - grid$alpha)))
write_case("psi", "2AFC, lapse rate marginalised", "data.csv", c(shape = '"logistic"',
  stim = '[-2, -1.8, -1.6, -1.4, -1.2, -1, -0.8, -0.6, -0.4, -0.2, 0, 0.2, 0.4, 0.6, 0.8, 1, 1.2, 1.4, 1.6, 1.8, 2]',
  alpha = '[-1.5, -1.375, -1.25, -1.125, -1, -0.875, -0.75, -0.625, -0.5, -0.375, -0.25, -0.125, 0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1, 1.125, 1.25, 1.375, 1.5]',
  beta = '[-0.5, -0.4, -0.3, -0.2, -0.1, 0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1]',
  gamma = '0.5',
  lambda = '[0, 0.02, 0.04, 0.06, 0.08, 0.1]',
  nuisance = '["lambda"]'))
bayesian_results(read.csv("data.csv")$response, levels, grid, hits, c("alpha", "beta", "gamma"), FALSE)
write_results()
