source("../R/case.R"); source("../R/lmm.R")
# A group between participants, a factor and two covariates within; little variance between participants; large numbers.
set.seed(63); n <- c(5, 3, 8, 6, 10, 4, 7, 2, 9, 6)
data <- data.frame(subject = rep(sprintf("P%02d", 1:10), n), group = rep(rep(c("dry", "wet"), 5), n), trial = unlist(lapply(n, seq_len)))
data$block <- (seq_len(nrow(data)) * 5) %% 4 + 1; data$load <- c("low", "high")[(seq_len(nrow(data)) * 3) %% 7 %% 2 + 1]
data$y <- round(100000 + rnorm(10, 0, .6)[rep(1:10, n)] + .8 * (data$group == "wet") + .1 * data$trial - .2 * data$block + .5 * (data$load == "high") + rnorm(nrow(data)), 3)
write_table(data, "data.csv")
write_case("lmm", "a factor between and one within participants, two covariates", "data.csv",
           c(fixed = paste0("{ \"group\": ", json_list(unique(data$group)), ", \"load\": ", json_list(unique(data$load)), " }"), covariates = json_list(c("trial", "block"))))
lmm_results(data, c("group", "load"), c("trial", "block"))
write_results()
