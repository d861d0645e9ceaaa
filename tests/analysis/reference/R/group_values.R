# Two groups of participants in a number of each, or in profiles over items without each participant's own mean. The permutation
# tests count every division, with blocks every one that keeps the number of participants of a group in each block.
divisions <- function(is_first, block) {
  parts <- lapply(unique(block), function(b) {
    own <- which(block == b); lapply(combn(length(own), sum(is_first[own]), simplify = FALSE), function(s) own[s])
  })
  grid <- as.matrix(do.call(expand.grid, lapply(parts, seq_along)))
  lapply(seq_len(nrow(grid)), function(r) unlist(Map(function(part, k) part[[k]], parts, grid[r, ])))
}
smallest_p <- function(is_first, block, ways) (if (all(tapply(is_first, block, mean) == 0.5)) 2 else 1) / length(ways)
blocks_of <- function(data) if (is.null(data$block)) rep("all", nrow(data)) else data$block
as_far <- function(statistics, observed) mean(statistics >= observed * (1 - 1e-9))

group_values_results <- function(data, groups, ratio, confidence) {
  known <- data[!is.na(data$value), ]
  rows("values.missing", groups, sapply(groups, function(g) sum(is.na(data$value[data$group == g]))), "count")
  complete <- nrow(known) == nrow(data)
  scaled <- if (ratio) log(known$value) else known$value
  a <- scaled[known$group == groups[1]]; b <- scaled[known$group == groups[2]]
  back <- if (ratio) exp else identity
  rows("values.mean", groups, back(c(mean(a), mean(b))))
  row("values.shift", "", mean(a) - mean(b))
  if (ratio) row("values.ratio", "", exp(mean(a) - mean(b)))
  welch <- t.test(a, b, conf.level = confidence)
  row("values.welch.t", "", welch$statistic[[1]]); row("values.welch.df", "", welch$parameter[[1]])
  row("values.welch.p.two", "", welch$p.value, "tail")
  n <- length(a) + length(b); pooled <- sqrt(((length(a) - 1) * var(a) + (length(b) - 1) * var(b)) / (n - 2))
  f <- n - 2; row("values.hedges.g", "", (mean(a) - mean(b)) / pooled * exp(lgamma(f / 2) - lgamma((f - 1) / 2)) / sqrt(f / 2), "optimum")
  is_first <- known$group == groups[1]; block <- blocks_of(known); ways <- divisions(is_first, block)
  row(if (ratio) "values.log.perm.p.two" else "values.perm.p.two", "", as_far(sapply(ways, function(w) abs(mean(scaled[w]) - mean(scaled[-w]))), abs(mean(a) - mean(b))))
  row("values.perm.draws", "", 0, "count")
  row("values.perm.smallest", "", smallest_p(is_first, block, ways))
}

group_profiles_results <- function(data, groups, confidence) {
  items <- unique(data$item); subjects <- unique(data$subject)
  x <- t(sapply(subjects, function(s) data$value[data$subject == s][match(items, data$item[data$subject == s])]))
  group <- sapply(subjects, function(s) data$group[data$subject == s][1])
  block <- sapply(subjects, function(s) blocks_of(data)[data$subject == s][1])
  keep <- complete.cases(x); row("profile.incomplete", "", sum(!keep), "count")
  x <- x[keep, ]; group <- group[keep]; block <- block[keep]; x <- x - rowMeans(x)
  for (j in seq_along(items)) {
    a <- x[group == groups[1], j]; b <- x[group == groups[2], j]
    rows("profile.mean", paste(groups, items[j], sep = "|"), c(mean(a), mean(b)))
    row("profile.diff", items[j], mean(a) - mean(b))
  }
  # sums of squares from the residuals of two linear models
  r2 <- function(second) 1 - sum(resid(lm(x ~ second))^2) / sum(resid(lm(x ~ 1))^2)
  observed <- r2(group == groups[2]); row("profile.r2", "", observed)
  n <- nrow(x); is_first <- group == groups[1]; ways <- divisions(is_first, block)
  row("profile.perm.p", "", as_far(sapply(ways, function(w) r2(!(seq_len(n) %in% w))), observed))
  row("profile.perm.draws", "", 0, "count")
  row("profile.perm.smallest", "", smallest_p(is_first, block, ways))
}
