source("../R/case.R"); source("../R/recognition.R")
set.seed(11); labels <- c("cork", "felt", "slate", "rubber", "linen")
data <- do.call(rbind, lapply(1:9, function(person) {
  stimulus <- sample(rep(labels, 3)); near <- labels[pmin(5, match(stimulus, labels) + 1)]
  data.frame(subject = paste0("P", person), trial = 1:15, stimulus = stimulus, response = ifelse(runif(15) < .62, stimulus, ifelse(runif(15) < .6, near, sample(labels, 15, TRUE))))
}))
data$response[c(7, 90)] <- NA
write_table(data, "trials.csv")
write_case("recognition", "one of five, neighbours confused, two answers missing", "trials.csv", c(labels = json_list(labels), conf = "0.9"))
recognition_results(data, labels, .9)
write_results()
