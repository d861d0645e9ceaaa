# Changes over the trials: halves of each participant's trials, blocks of trials; of times the slope by lm.
halves_of <- function(rows) { n <- nrow(rows) %/% 2; list(head(rows, n), tail(rows, n)) }
in_order <- function(data) lapply(split(data, factor(data$subject, unique(data$subject))), function(own) own[order(own$trial), ])
block_names <- function(last, width) {
  first <- seq(1, last, width); end <- pmin(first + width - 1, last)
  ifelse(first == end, first, paste(first, end, sep = "-"))
}
with_limits <- function(quantity, key, logs, confidence) {
  row(quantity, key, exp(mean(logs))); limits <- exp(t.test(logs, conf.level = confidence)$conf.int)
  row(paste0(quantity, ".lower"), key, limits[1]); row(paste0(quantity, ".upper"), key, limits[2])
}
learning_of_times <- function(data, most, confidence) {
  last <- max(data$trial); width <- ceiling(last / most); names <- block_names(last, width)
  row("n.untimed", "", sum(is.na(data$time_s)), "count")
  people <- in_order(data[!is.na(data$time_s), ])
  halves <- sapply(people, function(own) sapply(halves_of(own), function(half) mean(log(half$time_s))))
  slopes <- sapply(people, function(own) 10 * coef(lm(log(time_s) ~ trial, own))[["trial"]])
  with_limits("half.first", "", halves[1, ], confidence); with_limits("half.second", "", halves[2, ], confidence)
  with_limits("half.ratio", "", halves[2, ] - halves[1, ], confidence)
  with_limits("slope.ratio", "", slopes, confidence)
  rows("subject.half.ratio", names(people), exp(halves[2, ] - halves[1, ])); rows("subject.slope.ratio", names(people), exp(slopes))
  blocks <- sapply(people, function(own) tapply(log(own$time_s), factor((own$trial - 1) %/% width, seq_along(names) - 1), mean))
  for (i in seq_along(names)) {
    own <- blocks[i, !is.na(blocks[i, ])]
    with_limits("block", names[i], own, confidence)
    rows("subject.block", paste(names(own), names[i], sep = "|"), exp(own))
  }
}
learning_of_proportions <- function(data, most, confidence) {
  last <- max(data$trial); width <- ceiling(last / most); names <- block_names(last, width)
  people <- in_order(data); share <- function(rows) sum(rows$correct) / sum(rows$items)
  halves <- sapply(people, function(own) sapply(halves_of(own), share))
  row("half.first", "", mean(halves[1, ])); row("half.second", "", mean(halves[2, ]))
  difference <- halves[2, ] - halves[1, ]; limits <- t.test(difference, conf.level = confidence)$conf.int
  row("half.difference", "", mean(difference)); row("half.difference.lower", "", limits[1]); row("half.difference.upper", "", limits[2])
  rows("subject.half.difference", names(people), difference)
  blocks <- sapply(people, function(own) sapply(seq_along(names), function(i) share(own[(own$trial - 1) %/% width == i - 1, ])))
  for (i in seq_along(names)) {
    own <- blocks[i, !is.nan(blocks[i, ])]
    row("block", names[i], mean(own)); rows("subject.block", paste(names(own), names[i], sep = "|"), own)
  }
}
