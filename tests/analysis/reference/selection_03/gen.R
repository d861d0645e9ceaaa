source("../R/case.R"); source("../R/selection.R")
data <- data.frame(subject = c("A", "B", "C"), sample = "only", choice = "this")
write_table(data, "choices.csv")
write_case("selection", "two alternatives, one sample, everybody chooses the same", "choices.csv",
           c(renderers = json_list(c("this", "that")), target = json_text("this"), conf = "0.95"))
selection_results(data, c("this", "that"), "this", .95)
write_results()
