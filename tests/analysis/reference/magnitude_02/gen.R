source("../R/case.R"); source("../R/magnitude.R")
# Straight and steep: no peak is inside; zeros stand for half of the least.
set.seed(32); data <- expand.grid(spacing = c(.5, 1, 2, 4), rep = 1:3, probe = 2, subject = c("A", "B", "C", "D"))[, c("subject", "probe", "spacing", "rep")]
data$estimate <- signif(10^(.4 + .2 * as.numeric(data$subject) + .7 * log10(data$spacing) + rnorm(nrow(data), 0, .1)), 2); data$estimate[c(1, 14)] <- 0; data$estimate[30] <- NA
write_table(data, "estimates.csv")
write_case("magnitude", "power law, half of the least for zeros, a standard with modulus", "estimates.csv",
           c(zero_rule = json_text("halfmin"), normalisation = json_text("standard"), standard_spacing = "1", modulus = "50", conf = "0.9"))
magnitude_results(data, "halfmin", standard = 1, modulus = 50, confidence = .9)
write_results()
