source("../R/case.R"); source("../R/matching.R")
set.seed(51)
one <- function(subject, group, trial, skill) { items <- sample(c("cork", "felt", "glass", "jute", "slate")); answer <- items; wrong <- runif(5) > skill; if (sum(wrong) > 1) answer[wrong] <- sample(answer[wrong])
  data.frame(subject, group, trial, stimulus = items, response = answer) }
data <- do.call(rbind, lapply(1:7, function(s) do.call(rbind, lapply(1:2, function(t) one(paste0("P", s), if (s %% 3) "left" else "right", t, s / 8)))))
write_table(data, "trials.csv")
write_case("matching", "five textures, seven participants, two trials each, groups of unequal size", "trials.csv", c(conf = "0.9"))
matching_results(data, .9)
write_results()
