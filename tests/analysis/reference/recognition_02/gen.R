source("../R/case.R"); source("../R/recognition.R")
# One participant, all right, one stimulus never presented.
labels <- c("a", "b", "c", "d"); data <- data.frame(subject = "only", trial = 1:9, stimulus = rep(c("a", "b", "c"), 3)); data$response <- data$stimulus
write_table(data, "trials.csv")
write_case("recognition", "one participant, all right, a stimulus without trials", "trials.csv", c(labels = json_list(labels)))
recognition_results(data, labels, .95)
write_results()
