source("../R/case.R"); source("../R/glmm.R")
data <- drawn_responses(3, 20, 6, 2, c(only = 0.2), c(0.9, 0.6))[, c("subject", "item", "correct", "trials")]
write_table(data, "responses.csv")
write_case("glmm", "twenty participants, six items of two trials, one condition, logit", "responses.csv", c(chance = "0.25"))
glmm_results(data, "logit", chance = 0.25)
write_results()
