source("../R/case.R"); source("../R/glmm.R")
data <- drawn_choices(12, 14, 30, c(1.8, -12), 0.7)
write_table(data, "responses.csv")
write_case("glmm", "choices of one of two surfaces by the differences of force and speed, participants alone, logit", "responses.csv",
           c(random = json_list("subject"), covariates = json_list(c("force_difference_N", "speed_difference_m_per_s"))))
glmm_results(data, "logit", random = "subject", covariates = c("force_difference_N", "speed_difference_m_per_s"))
write_results()
