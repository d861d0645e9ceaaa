# The participants' own means or medians, and their distribution over participants.
description_results <- function(data, factors, average) {
  row("n.missing", "", sum(is.na(data$value)), "count")
  of_condition <- function(key, data) {
    data <- data[!is.na(data$value), ]; row("measurements", key, nrow(data), "count")
    if (nrow(data) == 0) return(invisible())
    own <- sapply(split(data$value, factor(data$subject, unique(data$subject))), average)
    row("mean", key, mean(own)); if (length(own) > 1) row("sd", key, sd(own))
    row("median", key, median(own)); row("quartile.lower", key, quantile(own, .25)); row("quartile.upper", key, quantile(own, .75))
    rows("subject.value", if (key == "") names(own) else paste(names(own), key, sep = "|"), own)
  }
  of_condition("", data)
  for (factor in names(factors)) for (level in factors[[factor]])
    of_condition(paste0(factor, "=", level), data[!is.na(data[[factor]]) & data[[factor]] == level, ])
}
