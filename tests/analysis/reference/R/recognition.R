# Recognition of one of several stimuli. d' by the trapezoid rule, the choice model by a Poisson regression, maps and trees by R's
# own functions.
choice_share <- function(d, m) { x <- seq(d - 10, d + 10, by = 1e-3); sum(dnorm(x - d) * pnorm(x)^(m - 1)) * 1e-3 }
choice_dprime <- function(share, m) {
  if (share == 0) return(-Inf)
  if (share == 1) return(Inf)
  d <- uniroot(function(d) choice_share(d, m) - share, c(-12, 12), tol = 1e-13)$root
  step <- 1e-4
  for (i in 1:3) d <- d - (choice_share(d, m) - share) * 2 * step / (choice_share(d + step, m) - choice_share(d - step, m))
  d
}
transfer <- function(counts) {
  p <- counts / sum(counts); by_chance <- outer(rowSums(p), colSums(p))
  sum(ifelse(p > 0, p * log2(p / by_chance), 0))
}
entropy <- function(counts) { p <- counts[counts > 0] / sum(counts); sum(p * log2(1 / p)) }
pairs_of <- function(labels) t(combn(labels, 2))
pair_rows <- function(quantity, matrix, labels, known) {
  dimnames(matrix) <- list(labels, labels); pairs <- pairs_of(labels)
  rows(quantity, paste(pairs[, 1], pairs[, 2], sep = "|"), matrix[pairs], known)
}

quasi_symmetry <- function(counts, labels) {
  m <- length(labels); pair <- counts + t(counts)
  added <- if (any(pair == 0)) 0.5 else 0
  cell <- expand.grid(stimulus = labels, answer = labels); cell$count <- as.vector(counts) + added
  cell$pair <- factor(apply(cell[, 1:2], 1, function(two) paste(sort(two), collapse = " ")))
  fit <- suppressWarnings(glm(count ~ stimulus + answer + pair, poisson, cell, control = glm.control(1e-12, 100)))
  mu <- matrix(fitted(fit), m, m)
  row("scm.added", "", added)
  row("scm.G2", "", deviance(fit), "optimum"); row("scm.X2", "", sum(residuals(fit, "pearson")^2), "optimum")
  df <- (m - 1) * (m - 2) / 2; row("scm.df", "", df, "count")
  row("scm.p", "", pchisq(deviance(fit), df, lower.tail = FALSE), "optimum")
  own <- diag(mu)
  pair_rows("scm.eta", sqrt(mu * t(mu) / outer(own, own)), labels, "optimum")
  # The odds of answering j rather than i, averaged over both stimuli, are b_j / b_i.
  log_bias <- sapply(1:m, function(j) 0.5 * (log(mu[1, j] / mu[1, 1]) + log(mu[j, j] / mu[j, 1])))
  rows("scm.bias", labels, exp(log_bias) / sum(exp(log_bias)), "optimum")
}

structure_of <- function(name, distances, labels) {
  pair_rows(paste0("dis.", name), distances, labels, "formula")
  map <- suppressWarnings(cmdscale(as.dist(distances), 2, eig = TRUE))
  rows(paste0("mds.", name, ".eig"), seq_along(labels), map$eig, "curvature")
  row(paste0("mds.", name, ".gof1"), "", map$GOF[1], "curvature"); row(paste0("mds.", name, ".gof2"), "", map$GOF[2], "curvature")
  if (all(abs(diff(map$eig[1:3])) > 1e-6)) pair_rows(paste0("mds.", name, ".dist2d"), as.matrix(dist(map$points)), labels, "curvature")
  for (linkage in c("average", "complete", "single")) {
    tree <- hclust(as.dist(distances), linkage); start <- paste("hclust", name, linkage, sep = ".")
    together <- cophenetic(tree)
    flat <- diff(range(together)) < 1e-12 || diff(range(as.dist(distances))) < 1e-12
    row(paste0(start, ".cophcor"), "", if (flat) NA else cor(together, as.dist(distances)), "curvature")
    rows(paste0(start, ".height"), seq_len(length(labels) - 1), tree$height)
    pair_rows(paste0(start, ".cophenetic"), as.matrix(together), labels, "formula")
  }
}

recognition_results <- function(data, labels, confidence) {
  m <- length(labels)
  row("n.missing", "", sum(is.na(data$response)), "count"); data <- data[!is.na(data$response), ]
  counts <- matrix(0, m, m, dimnames = list(labels, labels))
  for (i in seq_len(nrow(data))) counts[data$stimulus[i], data$response[i]] <- counts[data$stimulus[i], data$response[i]] + 1
  for (a in labels) for (b in labels) row("confusion", paste(a, b, sep = "|"), counts[a, b], "count")
  n <- nrow(data); hit <- data$stimulus == data$response; k <- sum(hit)
  row("n", "", n, "count"); row("correct", "", k, "count"); row("pc", "", k / n)
  row("pc.wilson.lower", "", wilson(k, n, confidence)[1]); row("pc.wilson.upper", "", wilson(k, n, confidence)[2])
  row("pc.cp.lower", "", clopper_pearson(k, n, confidence)[1], "tail"); row("pc.cp.upper", "", clopper_pearson(k, n, confidence)[2], "tail")
  row("pc.p.greater", "", sum(dbinom(k:n, n, 1 / m)), "tail")
  # the participant as the unit
  hits <- tapply(hit, data$subject, sum); trials <- tapply(hit, data$subject, length); shares <- hits / trials; people <- length(shares)
  row("subj.mean", "", mean(shares)); row("subj.sd", "", if (people > 1) sd(shares) else NA)
  if (people < 2) row("subj.t", "", "undefined_one_participant")
  else if (diff(range(shares)) == 0) row("subj.t", "", "undefined_zero_variance")
  else {
    se <- sd(shares) / sqrt(people); t <- (mean(shares) - 1 / m) / se; half <- qt(0.5 + confidence / 2, people - 1) * se
    row("subj.t", "", t); row("subj.t.p.two", "", 2 * pt(-abs(t), people - 1), "tail")
    row("subj.ci.lower", "", mean(shares) - half); row("subj.ci.upper", "", mean(shares) + half)
  }
  row("pc.se.cluster", "", if (people > 1) sqrt(people * var(hits - k / n * trials)) / n else NA)
  for (a in labels) {
    presented <- sum(counts[a, ]); answered <- sum(counts[, a])
    row("recall", a, if (presented) counts[a, a] / presented else NA)
    if (!presented) next
    row("recall.wilson.lower", a, wilson(counts[a, a], presented, confidence)[1]); row("recall.wilson.upper", a, wilson(counts[a, a], presented, confidence)[2])
    row("precision", a, if (answered) counts[a, a] / answered else NA)
  }
  by_chance <- sum(outer(rowSums(counts), colSums(counts)) * diag(m)) / n^2
  row("kappa", "", if (by_chance == 1) NA else 1 - (1 - k / n) / (1 - by_chance))
  recalls <- diag(counts) / rowSums(counts); row("balanced.pc", "", mean(recalls, na.rm = TRUE))
  d <- choice_dprime(k / n, m); row("dprime", "", d, "optimum")
  if (is.finite(d)) row("dprime.se", "", sqrt(k / n * (1 - k / n) / n) * 2e-4 / (choice_share(d + 1e-4, m) - choice_share(d - 1e-4, m)), "optimum")
  else row("dprime.corrected", "", choice_dprime(if (k) 1 - 0.5 / n else 0.5 / n, m), "optimum")
  row("dprime.lower", "", choice_dprime(wilson(k, n, confidence)[1], m), "optimum"); row("dprime.upper", "", choice_dprime(wilson(k, n, confidence)[2], m), "optimum")
  # information
  bits <- transfer(counts); r <- sum(rowSums(counts) > 0); c <- sum(colSums(counts) > 0)
  row("H.stimulus", "", entropy(rowSums(counts))); row("H.response", "", entropy(colSums(counts)))
  row("IT.plugin", "", bits); row("IT.relative", "", if (r > 1) bits / entropy(rowSums(counts)) else NA); row("IT.items", "", 2^bits)
  row("IT.millermadow", "", bits + (r + c - sum(counts > 0) - 1) / (2 * n * log(2))); row("IT.miller1955", "", bits - (r - 1) * (c - 1) / (2 * n * log(2)))
  without <- sapply(seq_len(n), function(i) { fewer <- counts; fewer[data$stimulus[i], data$response[i]] <- fewer[data$stimulus[i], data$response[i]] - 1; transfer(fewer) })
  row("IT.jackknife", "", n * bits - (n - 1) * mean(without))
  row("G", "", 2 * n * log(2) * bits); row("G.df", "", (r - 1) * (c - 1), "count")
  row("G.p", "", if (r > 1 && c > 1) pchisq(2 * n * log(2) * bits, (r - 1) * (c - 1), lower.tail = FALSE) else 1, "tail")
  wrong <- 1 - k / n
  row("IT.from.pc", "", log2(m) - entropy(c(k, n - k)) - wrong * log2(m - 1)); row("IT.N.enough", "", n >= 5 * m * m)
  quasi_symmetry(counts, labels)
  # structure
  p <- (counts + 0.5) / rowSums(counts + 0.5); own <- diag(p)
  shepard <- pmax(-log(sqrt(p * t(p) / outer(own, own))), 0); shepard[abs(shepard) < 1e-15] <- 0; diag(shepard) <- 0
  row("dis.shepard.clamped", "", sum(shepard[upper.tri(shepard)] == 0), "count")
  structure_of("shepard", matrix(shepard, m), labels)
  linear <- 1 - (p + t(p)) / 2; diag(linear) <- 0
  structure_of("linear", linear, labels)
}
