source("../R/case.R"); source("../R/selection.R")
set.seed(41)
renderers <- c("map", "wave", "noise")
data <- expand.grid(sample = c("wood", "brick", "metal"), subject = sprintf("P%d", 1:7))[, 2:1]
data$choice <- sample(renderers, nrow(data), TRUE, c(.6, .35, .05))
data$choice[c(5, 16)] <- NA
write_table(data, "choices.csv")
write_case("selection", "three alternatives, one hardly ever chosen, two choices not made", "choices.csv",
           c(renderers = json_list(renderers), target = json_text("map"), conf = "0.95"))
selection_results(data, renderers, "map", .95)
write_results()
