source("../R/case.R"); source("../R/matching.R")
t <- function(subject, trial, stimulus, response) data.frame(subject, group = "all", trial, stimulus, response)
data <- rbind(t("x", "a", c("p", "q", "r"), c("q", "p", "r")), t("x", "b", c("p", "q", "r", "s"), c("p", "s", "r", "q")), t("x", "c", c("p", "p", "q"), c("p", "q", "p")),
              t("y", "a", c("r", "q", "p"), c(NA, NA, "p")), t("y", "b", c("p", "q", "r"), c("q", "q", "z")), t("y", "c", c("s", "q"), c("s", "q")), t("y", "d", "r", "r"))
data <- data[c(1, 4, 2, 5, 3, 6:nrow(data)), ]
write_table(data, "trials.csv")
write_case("matching", "trials of different sizes, blanks, repetitions, an image that was never felt, rows of two trials interleaved", "trials.csv", c(conf = "0.95"))
matching_results(data, .95)
write_results()
