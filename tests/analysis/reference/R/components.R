# item, scale, score and optionally subject: principal components by the singular values of the standardised means (prcomp);
# the program has the eigenvectors of the correlations. Parallel analysis and intervals draw random numbers and are not here.
components_results <- function(data) {
  data$score <- as.numeric(data$score)
  items <- unique(data$item); scales <- unique(data$scale)
  means <- tapply(data$score, list(factor(data$item, items), factor(data$scale, scales)), mean, na.rm = TRUE)
  found <- prcomp(means, scale. = TRUE)
  for (c in seq_along(scales)) {
    name <- paste0("C", c)
    loading <- found$rotation[, c] * found$sdev[c]
    largest <- which(abs(loading) >= max(abs(loading)) - 1e-9)[1]
    sign <- sign(loading[largest])
    row("eigenvalue", name, found$sdev[c]^2)
    row("proportion", name, found$sdev[c]^2 / length(scales))
    rows("loading", paste0(scales, "|", name), sign * loading, "tail")
    rows("score", paste0(items, "|", name), sign * found$x[, c], "tail")
  }
}
