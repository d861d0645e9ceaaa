source("../R/case.R"); source("../R/response_times.R")
# Five participants, two repetitions and two textures, of unequal numbers; three responses have no time.
set.seed(22)
data <- expand.grid(subject = c("P01", "P02", "P03", "P04", "P05"), repetition = 1:2, texture = c("wood", "metal"), KEEP.OUT.ATTRS = FALSE)
data <- rbind(data, data[c(1, 2, 7), ])
data$time_s <- round(exp(rnorm(nrow(data), 0.4 + 0.2 * (data$repetition == 1), 0.5)), 4)
data$time_s[c(3, 8, 14)] <- NA
data <- data[order(data$subject, data$repetition), ]
write_table(data, "data.csv")
write_case("response_times", "response times by repetition and texture, some missing", "data.csv",
           c(factors = "{\"repetition\": [1, 2], \"texture\": [\"wood\", \"metal\"]}", conf = "0.9"))
response_times_results(data, list(repetition = 1:2, texture = c("wood", "metal")), 0.9)
write_results()
