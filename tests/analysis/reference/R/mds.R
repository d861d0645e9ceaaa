# Dissimilarities of pairs: item, other, dissimilarity (each unordered pair once). Packages stats and MASS.
disparities <- function(d, delta) { o <- order(delta, d); y <- numeric(length(d)); y[o] <- isoreg(d[o])$yf; y } # primary approach to ties
stress_1 <- function(x, delta, k) { d <- as.vector(dist(matrix(x, ncol = k))); sqrt(sum((d - disparities(d, delta))^2) / sum(d^2)) }
smacof_ratio <- function(delta, X, steps) { n <- nrow(X); D <- as.matrix(delta); for (i in seq_len(steps)) { d <- as.matrix(dist(X)); B <- -ifelse(d > 0, D / d, 0); diag(B) <- 0; diag(B) <- -rowSums(B); Y <- B %*% X / n; if (max(abs(Y - X)) < 1e-14) break; X <- Y }
  d <- dist(X); list(X = X, raw = sum((delta - d)^2), stress = sqrt(sum((delta - d)^2) / sum(d^2))) }
mds_results <- function(data, items, k) {
  n <- length(items); D <- matrix(0, n, n, dimnames = list(items, items))
  for (i in seq_len(nrow(data))) D[data$item[i], data$other[i]] <- D[data$other[i], data$item[i]] <- as.numeric(data$dissimilarity[i])
  delta <- as.dist(D); pairs <- t(combn(items, 2)); key <- paste0(pairs[, 1], "|", pairs[, 2])
  distances <- function(X) { M <- as.matrix(dist(X)); dimnames(M) <- list(items, items); M[pairs] }
  map <- cmdscale(delta, k = k, eig = TRUE)
  rows("classical.eig", seq_len(n), map$eig, "curvature"); row("classical.gof1", "", map$GOF[1], "curvature"); row("classical.gof2", "", map$GOF[2], "curvature"); rows("classical.dist", key, distances(map$points), "curvature")
  # Metric scaling: the best of 61 starts.
  set.seed(1); best <- NULL
  for (s in 0:60) { start <- if (s == 0) map$points else matrix(rnorm(n * k), n) * mean(delta); fit <- smacof_ratio(delta, start, 3000); if (is.null(best) || fit$raw < best$raw - 1e-12) best <- fit }
  best <- smacof_ratio(delta, best$X, 50000)
  row("ratio.rawstress", "", best$raw, "optimum"); row("ratio.stress1", "", best$stress, "optimum"); rows("ratio.dist", key, distances(best$X), "curvature")
  # Non-metric scaling by gradients instead of majorisation (MASS::isoMDS), the best of 201 starts, then a general optimiser. It is written to its
  # own table: where the smallest stress is near 0, several configurations have it, and where it is not, these starts may miss it.
  least <- Inf; set.seed(2)
  for (s in 0:200) { start <- if (s == 0) map$points else matrix(rnorm(n * k), n); fit <- tryCatch(MASS::isoMDS(delta, y = start, k = k, maxit = 1000, trace = FALSE, tol = 1e-10), error = function(e) NULL); if (!is.null(fit) && fit$stress / 100 < least) { least <- fit$stress / 100; X <- fit$points } }
  o <- optim(as.vector(X), stress_1, delta = as.vector(delta), k = k, method = "BFGS", control = list(maxit = 5000, reltol = 1e-16)); if (o$value < least) { least <- o$value; X <- matrix(o$par, ncol = k) }
  d <- distances(X)
  if (least < 1e-9) row("nonmetric.stress1", "", least, "curvature") else write_table(data.frame(item = pairs[, 1], other = pairs[, 2], distance = sprintf("%.15g", d / sqrt(mean(d^2)))), "local_minimum.csv")
}
