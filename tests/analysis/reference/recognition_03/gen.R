source("../R/case.R"); source("../R/recognition.R")
# Nothing right, and equally so for everybody; what was never answered has no precision.
labels <- c("x", "y", "z"); data <- data.frame(subject = rep(c("P1", "P2", "P3"), each = 4), trial = 1:4, stimulus = c("x", "y", "z", "x"), response = c("y", "x", "x", "y"))
write_table(data, "trials.csv")
write_case("recognition", "nothing right, one answer never given", "trials.csv", c(labels = json_list(labels), conf = "0.95"))
recognition_results(data, labels, .95)
write_results()
