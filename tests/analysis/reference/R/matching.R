# Textures assigned to images: subject, group, trial, stimulus, response (NA where blank), one row per place.
dealt <- function(stimulus, response) {
  response[is.na(response)] <- ""
  P <- permutations(length(stimulus))
  right <- apply(P, 1, function(order) sum(response[order] == stimulus))
  table(right) / nrow(P)
}
upper <- function(p, x) sum(p[as.numeric(names(p)) >= x])

matching_results <- function(data, confidence) {
  data$name <- paste(data$subject, data$trial, sep = ":"); names_of <- unique(data$name)
  trials <- lapply(names_of, function(t) data[data$name == t, ]); size <- sapply(trials, nrow)
  right <- sapply(trials, function(d) sum(d$response == d$stimulus, na.rm = TRUE))
  permutation <- sapply(trials, function(d) identical(sort(d$stimulus), sort(d$response)) && !anyDuplicated(d$stimulus))
  chance <- lapply(trials, function(d) { p <- dealt(d$stimulus, d$response); setNames(as.numeric(p), names(p)) })
  rows("fixed.points", names_of, right, "count")
  p <- Reduce(sum_of, chance); value <- as.numeric(names(p)); total <- sum(right); mean0 <- sum(value * p); sd0 <- sqrt(sum((value - mean0)^2 * p))
  row("n.trials", "", length(trials), "count"); row("n.trials.permutation", "", sum(permutation), "count")
  row("total.correct", "", total, "count"); row("mean.correct", "", mean(right)); row("null.mean", "", mean0); row("null.sd", "", sd0)
  row("exact.p.greater", "", upper(p, total), "tail"); row("exact.midp.greater", "", (upper(p, total) + upper(p, total + 1)) / 2, "tail")
  row("exact.p.less", "", sum(p[value <= total]), "tail"); row("z", "", (total - mean0) / sd0)
  rows("trials.with.k", 0:max(size), sapply(0:max(size), function(k) sum(right == k)), "count")
  m <- size[1]; one <- sapply(0:m, function(k) mean(rowSums(permutations(m) == matrix(1:m, factorial(m), m, byrow = TRUE)) == k))
  rows("null.pmf", paste0("n=", m, ";k=", 0:m), one); row("prop.correct", "", total / sum(size))
  whole <- sum(permutation & right == size); row("perfect.trials", "", whole, "count")
  if (any(permutation)) { w <- wilson(whole, sum(permutation), confidence); row("perfect.wilson.lower", "", w[1]); row("perfect.wilson.upper", "", w[2])
    if (all(size == m)) row("perfect.p.greater", "", sum(dbinom(whole:sum(permutation), sum(permutation), 1 / factorial(m))), "tail") }
  felt <- sort(unique(data$stimulus))
  for (s in felt) {
    hit <- unlist(lapply(trials[permutation], function(d) d$response[d$stimulus == s] == s)); if (!length(hit)) next
    coins <- lapply(trials[permutation], function(d) rep(1 / nrow(d), sum(d$stimulus == s)))
    p <- Reduce(sum_of, lapply(unlist(coins), function(q) c("0" = 1 - q, "1" = q)))
    row("texture.hits", s, sum(hit), "count"); row("texture.prop", s, mean(hit)); row("texture.p.greater", s, upper(p, sum(hit)), "tail")
    }
  for (i in felt) for (j in felt) row("confusion", paste0(i, "|", j), sum(data$stimulus == i & data$response %in% j), "count")
  use <- permutation & size == m
  if (any(use)) {
    F <- right[use]; N <- length(F); k <- 0:m; row("mallows.n", "", N, "count")
    loglik <- function(theta) sum(F) * theta - N * log(sum(one * exp(theta * k)))
    if (mean(F) > 0 && mean(F) < m) {
      weights <- function(theta) { w <- one * exp(theta * k); w / sum(w) }
      theta <- uniroot(function(t) sum(k * weights(t)) - mean(F), c(-20, 20), tol = 1e-14)$root; w <- weights(theta)
      limit <- qchisq(confidence, 1) / 2; beyond <- function(t) loglik(theta) - loglik(t) - limit
      row("mallows.theta", "", theta, "optimum"); row("mallows.se", "", 1 / sqrt(N * (sum(k^2 * w) - sum(k * w)^2)), "optimum"); row("mallows.lr", "", 2 * (loglik(theta) - loglik(0)), "optimum")
      row("mallows.ci.lower", "", uniroot(beyond, c(theta - 30, theta), tol = 1e-13)$root, "optimum"); row("mallows.ci.upper", "", uniroot(beyond, c(theta, theta + 30), tol = 1e-13)$root, "optimum")
    } else row("mallows.theta", "", if (mean(F) > 0) Inf else -Inf)
  }
  subject <- sapply(trials, function(d) d$subject[1]); people <- unique(subject); means <- sapply(people, function(u) mean(right[subject == u]))
  rows("subject.mean", people, means)
  for (u in people) row("subject.p.greater", u, upper(Reduce(sum_of, chance[subject == u]), sum(right[subject == u])), "tail")
  group <- sapply(people, function(u) data$group[data$subject == u][1]); names_of <- sort(unique(group))
  if (length(names_of) == 2) {
    n <- length(people); first <- group == names_of[1]; key <- paste(names_of, collapse = "-"); difference <- function(in_first) mean(means[in_first]) - mean(means[!in_first])
    all <- Filter(function(x) sum(x) == sum(first), lapply(0:(2^n - 1), function(x) bitwAnd(x, 2^(0:(n - 1))) > 0))
    row("group.diff", key, difference(first)); row("group.perm.p.two", key, mean(abs(sapply(all, difference)) >= abs(difference(first)) - 1e-9), "tail")
  }
}
