# subject, item, score: the cumulative link mixed model with clmm of the package ordinal (Laplace approximation); the program
# has its own Newton iterations.
ordinal_results <- function(data, items) {
  data$score <- as.numeric(data$score)
  data <- data[!is.na(data$score), ]
  data$rating <- factor(data$score, ordered = TRUE)
  data$item <- factor(data$item, levels = items)
  data$subject <- factor(data$subject)
  full <- ordinal::clmm(rating ~ item + (1 | subject), data = data, Hess = TRUE)
  none <- ordinal::clmm(rating ~ 1 + (1 | subject), data = data)
  row("n.responses", "", nrow(data), "count")
  row("n.categories", "", nlevels(data$rating), "count")
  found <- summary(full)$coefficients
  for (item in items[-1]) {
    beta <- found[paste0("item", item), "Estimate"]
    error <- found[paste0("item", item), "Std. Error"]
    row("logodds", item, beta, "curvature")
    row("logodds.se", item, error, "curvature")
    row("wald.z", item, beta / error, "curvature")
    row("wald.p", item, 2 * pnorm(-abs(beta / error)), "curvature")
  }
  row("sigma.participants", "", as.numeric(full$ST[[1]]), "curvature")
  ratio <- 2 * (as.numeric(logLik(full)) - as.numeric(logLik(none)))
  row("lr.chisq", "", ratio, "curvature")
  row("lr.df", "", length(items) - 1, "count")
  row("lr.p", "", pchisq(ratio, length(items) - 1, lower.tail = FALSE), "curvature")
  row("mcfadden.r2", "", 1 - as.numeric(logLik(full)) / as.numeric(logLik(none)), "curvature")
}
# Ratings of 1 to `categories` by the model itself.
ordinal_data <- function(people, items, effects, repeats, categories, spread, of_people) {
  cuts <- seq(-spread, spread, length.out = categories - 1)
  data <- expand.grid(repetition = seq_len(repeats), item = items, subject = seq_len(people))
  own <- rnorm(people, sd = of_people)
  latent <- effects[match(data$item, items)] + own[data$subject] + rlogis(nrow(data))
  data.frame(subject = paste0("p", data$subject), item = as.character(data$item),
             score = 1 + rowSums(outer(latent, cuts, ">")))
}
