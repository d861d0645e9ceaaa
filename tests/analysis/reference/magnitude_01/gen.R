source("../R/case.R"); source("../R/magnitude.R")
set.seed(31); people <- paste0("P", 1:7); data <- expand.grid(spacing = c(.4, .8, 1.6, 2.4, 3.6), rep = 1:2, probe = c(1.5, 3), subject = people)[, c("subject", "probe", "spacing", "rep")]
own <- rnorm(7, 1, .3); shift <- rnorm(7, 0, .06); i <- match(data$subject, people)
data$estimate <- signif(10^(own[i] - 1.3 * (log10(data$spacing) - log10(.8 * data$probe) - shift[i])^2 + rnorm(nrow(data), 0, .08)), 2)
data$estimate[3] <- 0; data$estimate[50] <- NA; data$estimate[data$subject == "P4" & data$probe == 3 & data$spacing == .8] <- NA
draws <- matrix(sample(6, 6 * 120, TRUE), 120, dimnames = list(NULL, paste0("s", 1:6)))
write_table(data, "estimates.csv"); write_table(data.frame(b = 1:120, draws), "boot.csv")
write_case("magnitude", "two probes, a zero left out, one participant incomplete, resamples", c("estimates.csv", "boot.csv"),
           c(zero_rule = json_text("exclude"), normalisation = json_text("geomean"), standard_spacing = "null", modulus = "null", conf = "0.95"))
magnitude_results(data, "exclude", resamples = draws)
write_results()
