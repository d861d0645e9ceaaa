source("../R/case.R"); source("../R/glmm.R")
data <- drawn_responses(4, 15, 8, 3, c(light = -0.4, medium = 0.3, firm = 0.7), c(0.7, 1))
data <- data[-c(5, 18, 40:47, 200), ]  # some participants missed some
write_table(data, "responses.csv")
write_case("glmm", "fifteen participants, eight items, three conditions, some missing, probit", "responses.csv", c(link = json_text("probit"), fixed = "{\"condition\": [\"light\", \"medium\", \"firm\"]}"))
glmm_results(data, "probit", "condition")
write_results()
