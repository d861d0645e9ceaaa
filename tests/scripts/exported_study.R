# What R makes of an exported study, with R alone: loads it by import.R, leaves the tidy tables that `asperity analyze --table`
# takes, and in results.csv R's own numbers. Arguments: the folder of the export, the folder to write into.
arguments <- commandArgs(trailingOnly = TRUE)
source(file.path(arguments[1], "import.R"), chdir = TRUE)
setwd(arguments[2])

stopifnot(is.logical(tables$attempts$valid), is.character(tables$participants$participant), is.factor(tables$sessions$mode),
          is.character(tables$sessions$seed), is.numeric(tables$responses$time_s),
          nrow(answered_trials("run")) == 0)  # nobody here is a person
refusal <- try(answered_trials(), silent = TRUE)
stopifnot(inherits(refusal, "try-error"), grepl("answered_trials(\"virtual\")", refusal, fixed = TRUE))
answers <- answered_trials(who = "virtual")
answers <- answers[answers$question == "most_realistic", ]
stopifnot(nrow(answers) > 0)
# The table with a row per participant says the same as the rows.
wide <- tables$virtual_wide
stopifnot(nrow(wide) == length(unique(answers$participant)), sum(wide$answers) == nrow(answers))

results <- data.frame(kind = character(), quantity = character(), key = character(), value = numeric())
note <- function(kind, quantity, key, value) {
  results[nrow(results) + 1, ] <<- list(kind, quantity, key, as.numeric(value))
}
models <- sort(unique(as.character(answers$answer)))

# Proportions: how often each model was chosen.
counts <- data.frame(id = models, k = sapply(models, function(model) sum(answers$answer == model)), n = nrow(answers),
                     p0 = 1 / 3, conf = 0.95)
write.csv(counts, "counts.csv", row.names = FALSE, quote = FALSE)
for (i in seq_along(models)) {
  test <- binom.test(counts$k[i], counts$n[i], 1 / 3)
  note("proportion", "phat", models[i], counts$k[i] / counts$n[i])
  note("proportion", "p.two", models[i], test$p.value)
  note("proportion", "cp.lower", models[i], test$conf.int[1])
  note("proportion", "cp.upper", models[i], test$conf.int[2])
}

# Bradley-Terry: the model that was chosen has beaten the two others; the likelihood is that of a logistic regression.
pairs <- do.call(rbind, lapply(seq_len(nrow(answers)), function(i) {
  chosen <- as.character(answers$answer[i])
  others <- setdiff(models, chosen)
  data.frame(subject = answers$participant[i], first = chosen, second = others, winner = chosen)
}))
write.csv(pairs, "pairs.csv", row.names = FALSE, quote = FALSE)
design <- sapply(models[-1], function(model) (pairs$first == model) - (pairs$second == model))
fit <- glm(rep(1, nrow(pairs)) ~ 0 + design, family = binomial, control = list(epsilon = 1e-14, maxit = 100))
for (i in seq_along(models[-1])) {
  note("paired", "bt.ability", models[i + 1], coef(fit)[i])
  note("paired", "bt.se", models[i + 1], sqrt(diag(vcov(fit)))[i])
}

# Analysis of variance: how strongly each model pushed, by texture, within participants.
keys <- c("participant", "session", "trial", "attempt", "virtual", "mode")
felt <- merge(tables$presentations, answers[, c(keys, "valid")], by = keys)
data <- data.frame(subject = felt$participant, model = as.character(felt$model), texture = felt$texture,
                   y = felt$achieved_texture_force_N)
data <- data[order(data$subject, data$model, data$texture), ]
write.csv(data, "forces.csv", row.names = FALSE, quote = FALSE)
for (name in c("subject", "model", "texture")) data[[name]] <- factor(data[[name]])
strata <- summary(aov(y ~ model * texture + Error(subject / (model * texture)), data))
for (effect in c("model", "texture", "model:texture")) {
  rows <- strata[[paste0("Error: subject:", effect)]][[1]]
  note("rmanova", "F", effect, rows[1, "F value"])
  note("rmanova", "df1", effect, rows[1, "Df"])
  note("rmanova", "df2", effect, rows[2, "Df"])
  note("rmanova", "SS", effect, rows[1, "Sum Sq"])
  note("rmanova", "p", effect, rows[1, "Pr(>F)"])
}
results <- results[!is.na(results$value), ]
results$value <- sprintf("%.17g", results$value)
write.csv(results, "results.csv", row.names = FALSE, quote = FALSE)
writeLines(c(models, "--", levels(data$model), "--", levels(data$texture)), "levels.txt")
