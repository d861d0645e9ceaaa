# Two groups of participants. The mixed model by adaptive integration of each participant and a general optimiser, the exact tests by
# counting all splits.
mixed_log_likelihood <- function(parameters, data) {
  level <- parameters[1] + parameters[2] * data$second; sigma <- exp(parameters[3])
  sum(sapply(seq_len(nrow(data)), function(i) {
    density <- function(u) dbinom(data$correct[i], data$trials[i], plogis(level[i] + sigma * u)) * dnorm(u)
    peak <- optimize(function(u) log(density(u)), c(-8, 8), maximum = TRUE, tol = 1e-8)$maximum
    inside <- integrate(density, peak - 9, peak + 9, rel.tol = 1e-12, subdivisions = 2000)$value
    log(inside)
  }))
}
# Newton's steps on differences, from where the general optimiser ended.
sharpened <- function(f, x, steps = 6, h = 1e-3) {
  for (i in seq_len(steps)) { d <- differences(f, x, h); x <- x - solve(d$hessian, d$gradient) }
  x
}
group_results <- function(data, groups, confidence) {
  data$second <- as.numeric(data$group == groups[2])
  k <- sapply(groups, function(g) sum(data$correct[data$group == g])); n <- sapply(groups, function(g) sum(data$trials[data$group == g]))
  rows("pooled.k", groups, k, "count"); rows("pooled.n", groups, n, "count")
  table <- rbind(k, n - k)
  for (side in c("two", "greater", "less")) row(paste0("fisher.p.", side), "", fisher.test(table, alternative = if (side == "two") "two.sided" else side)$p.value, "tail")
  # the noncentral hypergeometric distribution, its terms written out
  x <- max(0, sum(k) - n[2]):min(n[1], sum(k)); weight <- choose(n[1], x) * choose(n[2], sum(k) - x)
  probability <- function(log_odds) { w <- log(weight) + log_odds * x; w <- exp(w - max(w)); w / sum(w) }
  solve_for <- function(f) exp(uniroot(function(l) f(probability(l)), c(-25, 25), tol = 1e-14)$root)
  outside <- (1 - confidence) / 2; low <- k[1] == min(x); high <- k[1] == max(x)
  row("fisher.or.cond", "", if (low) 0 else if (high) Inf else solve_for(function(p) sum(p * x) - k[1]), "optimum")
  row("fisher.or.lower", "", if (low) 0 else solve_for(function(p) sum(p[x >= k[1]]) - outside), "optimum")
  row("fisher.or.upper", "", if (high) Inf else solve_for(function(p) sum(p[x <= k[1]]) - outside), "optimum")
  cells <- c(k, n - k) + 0.5
  row("or.haldane", "", cells[[1]] * cells[[4]] / (cells[[2]] * cells[[3]])); row("or.haldane.selog", "", sqrt(sum(1 / cells)))
  share <- k / n; first <- wilson(k[1], n[1], confidence); second <- wilson(k[2], n[2], confidence)
  row("diff", "", share[[1]] - share[[2]])
  row("diff.newcombe.lower", "", share[[1]] - share[[2]] - sqrt((share[1] - first[1])^2 + (second[2] - share[2])^2))
  row("diff.newcombe.upper", "", share[[1]] - share[[2]] + sqrt((first[2] - share[1])^2 + (share[2] - second[1])^2))
  # participants
  own <- data$correct / data$trials; a <- own[data$second == 0]; b <- own[data$second == 1]; na <- length(a); nb <- length(b)
  rows("subj.mean", groups, c(mean(a), mean(b)))
  if (na > 1 && nb > 1 && sd(a) + sd(b) > 0) {
    va <- var(a) / na; vb <- var(b) / nb; t <- (mean(a) - mean(b)) / sqrt(va + vb); df <- (va + vb)^2 / (va^2 / (na - 1) + vb^2 / (nb - 1))
    row("welch.t", "", t); row("welch.df", "", df); row("welch.p.two", "", 2 * pt(-abs(t), df), "tail")
    f <- na + nb - 2; d <- (mean(a) - mean(b)) / sqrt((sum((a - mean(a))^2) + sum((b - mean(b))^2)) / f)
    row("cohen.d", "", d); row("hedges.g", "", d * gamma(f / 2) / (sqrt(f / 2) * gamma((f - 1) / 2)))
  } else row("welch.t", "", "undefined_zero_variance")
  splits <- combn(na + nb, na); pool <- c(a, b); differ <- function(s) mean(pool[s]) - mean(pool[-s])
  row("perm.p.two", "", mean(abs(apply(splits, 2, differ)) >= abs(mean(a) - mean(b)) - 1e-9), "tail")
  wins <- sum(outer(a, b, ">") + 0.5 * outer(a, b, "==")); ranks <- rank(pool)
  sums <- apply(splits, 2, function(s) sum(ranks[s])); middle <- mean(sums)
  row("mannwhitney.U", groups[1], wins); row("mannwhitney.exact.p.two", "", mean(abs(sums - middle) >= abs(sum(ranks[1:na]) - middle) - 1e-9), "tail")
  # regressions
  if (any(k == 0 | k == n)) { row("glm.status", "", "separated"); return(invisible()) }
  fit <- glm(cbind(correct, trials - correct) ~ second, binomial, data, control = glm.control(1e-15, 100)); keys <- c("intercept", groups[2])
  rows("glm.beta", keys, coef(fit), "optimum"); rows("glm.se", keys, summary(fit)$coefficients[, 2], "optimum")
  score <- model.matrix(fit) * (data$correct - data$trials * fitted(fit)); bread <- vcov(fit)
  rows("glm.se.cluster", keys, sqrt(diag(bread %*% (t(score) %*% score) %*% bread)), "optimum")
  f <- function(p) mixed_log_likelihood(p, data)
  best <- NULL
  for (sigma in c(0.1, 0.5, 1.5)) {
    found <- optim(c(coef(fit), log(sigma)), function(p) if (abs(p[3]) > 12) 1e10 else -f(p), control = list(reltol = 1e-10, maxit = 500))
    if (is.null(best) || found$value < best$value) best <- found
  }
  at_zero <- best$par[3] < log(0.01); row("mixed.boundary", "", at_zero)
  if (at_zero) return(invisible())
  top <- sharpened(f, unname(best$par)); curve <- differences(f, top, 1e-3)$hessian
  rows("mixed.beta", keys, top[1:2], "optimum"); rows("mixed.se", keys, sqrt(diag(solve(-curve)))[1:2], "curvature")
  row("mixed.sigma", "", exp(top[3]), "optimum"); row("mixed.loglik", "", f(top), "optimum")
  alike <- function(p) f(c(p[1], 0, p[2]))
  start <- optim(c(top[1] + top[2] / 2, top[3]), function(p) -alike(p), control = list(reltol = 1e-10))$par
  ratio <- 2 * (f(top) - alike(sharpened(alike, start)))
  row("mixed.lr.group", "", ratio, "optimum"); row("mixed.lr.group.p", "", pchisq(ratio, 1, lower.tail = FALSE), "optimum")
}
