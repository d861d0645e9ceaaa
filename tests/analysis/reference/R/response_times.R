# Geometric means over participants of their geometric means, the interval from t.test of the logarithms.
response_times_results <- function(data, factors, confidence) {
  row("n.untimed", "", sum(is.na(data$time_s)), "count")
  of_condition <- function(key, rows) {
    timed <- rows[!is.na(rows$time_s), ]
    own <- sapply(split(log(timed$time_s), factor(timed$subject, unique(data$subject))), mean)
    own <- own[!is.nan(own)]
    row("responses", key, nrow(timed), "count")
    row("geomean", key, exp(mean(own)))
    interval <- exp(t.test(own, conf.level = confidence)$conf.int)
    row("geomean.lower", key, interval[1]); row("geomean.upper", key, interval[2])
    rows("subject.geomean", if (key == "") names(own) else paste(names(own), key, sep = "|"), exp(own))
  }
  of_condition("", data)
  for (factor in names(factors)) for (level in factors[[factor]])
    of_condition(paste0(factor, "=", level), data[data[[factor]] == level, ])
}
