source("../R/case.R"); source("../R/description.R")
# Contact times; one participant felt one texture only, four surfaces have no time and one trial no texture.
set.seed(71); data <- expand.grid(rep = 1:3, texture = c("wood", "metal"), subject = paste0("P", 1:5), stringsAsFactors = FALSE)
data$value <- round(exp(rnorm(nrow(data), 1, .4)), 3); data$value[c(3, 11, 12, 30)] <- NA; data$texture[8] <- NA
data <- data[data$subject != "P5" | data$texture == "wood", c("subject", "texture", "value")]
write_table(data, "data.csv")
factors <- list(texture = c("metal", "wood"))
write_case("description", "medians by texture, with missing times", "data.csv", c(average = json_text("median"), factors = "{ \"texture\": [\"metal\", \"wood\"] }"))
description_results(data, factors, median)
write_results()
