source("../R/case.R"); source("../R/rmanova.R")
# The factors' names are not in the order of the alphabet; replicates; one participant incomplete.
set.seed(41); within <- list(spacing = c("0.5", "1", "2", "4"), force = c("1", "3")); data <- expand.grid(rep = 1:2, force = within$force, spacing = within$spacing, subject = paste0("P", 1:8))
data$y <- round(.4 * log(as.numeric(as.character(data$spacing))) - .1 * as.numeric(as.character(data$spacing)) + rnorm(8, 0, .4)[data$subject] + rnorm(nrow(data), 0, .25) * as.numeric(data$spacing), 3)
data <- data[-(5:6), c("subject", "spacing", "force", "y")]
write_table(data, "data.csv")
write_case("rmanova", "two factors within, replicates, one participant incomplete", "data.csv",
           c(within = "{ \"spacing\": [\"0.5\", \"1\", \"2\", \"4\"], \"force\": [\"1\", \"3\"] }", between = "null", trend = json_text("spacing"), trend_scale = json_text("log10"), conf = "0.95"))
rmanova_results(data, within, trend = "spacing", scale = "log10")
write_results()
