# Up-down staircases. Levels are products or sums of all moves so far from the start, except after a bound; the balanced performance is
# the root of the drift of a Markov chain of counts.
on_axis <- function(scale, x) if (scale == "linear") x else log10(x)
off_axis <- function(scale, y) if (scale == "linear") y else 10^y
after_move <- function(scale, level, size, steps) switch(scale, linear = level + steps * size, log10 = level * 10^(steps * size),
                                                         db = level * 10^(steps * size / 20), ratio = level * size^steps)

# The direction of the move after each response (0: none): a run of equal responses moves at every n-th of them.
moves_of <- function(responses, down, up) {
  run <- sequence(rle(responses)$lengths)
  ifelse(responses == 1, ifelse(run %% down == 0, -1, 0), ifelse(run %% up == 0, 1, 0))
}
staircase_of <- function(responses, rule) {
  moves <- moves_of(responses, rule$n_down, rule$n_up); moving <- which(moves != 0)
  reversal <- moving[c(FALSE, diff(moves[moving]) != 0)]
  steps <- rule$step; weight <- if (is.null(rule$step_up_ratio)) 1 else rule$step_up_ratio
  low <- if (is.null(rule$min)) -Inf else rule$min; high <- if (is.null(rule$max)) Inf else rule$max
  levels <- rule$start; clipped <- 0
  for (i in seq_along(responses)) {
    level <- levels[i]
    if (moves[i] != 0) {
      size <- steps[min(sum(reversal <= i) + 1, length(steps))]
      free <- after_move(rule$scale, levels[i], size, if (moves[i] > 0) weight else -1)
      level <- max(low, min(high, free)); clipped <- clipped + (level != free)
    }
    levels <- c(levels, level)
  }
  list(levels = levels[seq_along(responses)], next_level = levels[length(levels)], reversal = reversal, clipped = clipped)
}
# The chance that n correct responses in succession come before m incorrect ones, from the absorbing chain of the counts.
chance_of_down <- function(p, down, up) {
  states <- c(if (down > 1) paste0("c", 1:(down - 1)), if (up > 1) paste0("i", 1:(up - 1)), "new"); q <- matrix(0, length(states), length(states), dimnames = list(states, states))
  absorbed <- setNames(rep(0, length(states)), states)
  for (state in states) {
    correct <- if (grepl("^c", state)) as.numeric(substring(state, 2)) else 0
    incorrect <- if (grepl("^i", state)) as.numeric(substring(state, 2)) else 0
    if (correct + 1 == down) absorbed[state] <- p else q[state, paste0("c", correct + 1)] <- p
    if (incorrect + 1 < up) q[state, paste0("i", incorrect + 1)] <- 1 - p
  }
  unname(solve(diag(length(states)) - q, absorbed)["new"])
}
balance <- function(rule) {
  weight <- if (is.null(rule$step_up_ratio)) 1 else rule$step_up_ratio
  uniroot(function(p) chance_of_down(p, rule$n_down, rule$n_up) * (1 + weight) - weight, c(1e-9, 1 - 1e-9), tol = 1e-15)$root
}

rule_json <- function(rule) {
  value <- function(x) if (is.character(x)) json_text(x) else if (is.logical(x)) tolower(as.character(x)) else if (length(x) > 1) paste0("[", paste(sprintf("%.15g", x), collapse = ", "), "]") else sprintf("%.15g", x)
  paste0("{", paste0(json_text(names(rule)), ": ", sapply(rule, value), collapse = ", "), "}")
}
write_staircase_case <- function(title, rules)
  write_case("staircase", title, "tracks.csv",
             c(tracks = paste0("{\n", paste0("      ", json_text(names(rules)), ": ", sapply(rules, rule_json), collapse = ",\n"), "\n    }")))

staircase_results <- function(data, rules) for (track in names(rules)) {
  rule <- rules[[track]]; own <- data[data$track == track & !is.na(data$response), ]; own <- own[order(own$trial), ]
  found <- staircase_of(own$response, rule)
  rows("level", paste0(track, "|", own$trial), found$levels); row("next.level", track, found$next_level)
  row("n.reversals", track, length(found$reversal), "count"); row("n.clipped", track, found$clipped, "count")
  row("reversal.trials", track, paste(own$trial[found$reversal], collapse = ";"))
  used <- found$levels[found$reversal]; used <- used[seq_along(used) > rule$discard]
  if (isTRUE(rule$even) && length(used) %% 2) used <- used[-1]
  if (length(used)) {
    y <- on_axis(rule$scale, used); row("n.used", track, length(y), "count")
    row("threshold", track, off_axis(rule$scale, mean(y))); row("threshold.median", track, off_axis(rule$scale, median(y)))
    if (length(y) > 1) row("reversal.sd", track, sd(y))
    pairs <- length(y) / 2
    if (pairs == round(pairs)) row("threshold.se.midpoints", track, if (pairs > 1) sd(tapply(y, rep(1:pairs, each = 2), mean)) / sqrt(pairs) else NA)
  } else row("threshold", track, "insufficient_reversals")
  if (rule$n_up == 1) row("target.p", track, balance(rule)) else { row("target.p", track, NA); row("target.p.balance", track, balance(rule)) }
}
