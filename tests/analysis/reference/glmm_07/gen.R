source("../R/case.R"); source("../R/glmm.R")
data <- drawn_responses(21, 10, 5, 6, c(plain = 0.1, masked = -0.6), c(0.8, 0.5))
data$log_force <- round(rnorm(nrow(data), 0, 0.4), 3)
write_table(data, "responses.csv")
write_case("glmm", "a factor and a covariate, participants and items, probit", "responses.csv",
           c(link = json_text("probit"), fixed = "{\"condition\": [\"plain\", \"masked\"]}", covariates = json_text("log_force")))
glmm_results(data, "probit", fixed = "condition", covariates = "log_force")
write_results()
