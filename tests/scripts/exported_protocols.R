# Loads the export of a study of several protocols by its import.R, where a warning is a failure, and leaves counts and exact
# intervals of R's own for each. Arguments: the folder of the export, the file to write.
options(warn = 2)
arguments <- commandArgs(trailingOnly = TRUE)
source(file.path(arguments[1], "import.R"), chdir = TRUE)

# Every column of every table has the type that the codebook declares.
codebook <- asperity_codebook(arguments[1])
for (name in names(tables)) {
  told <- codebook[gsub("/", "_", sub("\\.(tsv|csv)$", "", codebook$file)) == name, ]
  stopifnot(setequal(told$column, names(tables[[name]])))
  for (column in told$column) {
    cells <- tables[[name]][[column]]
    row <- told[told$column == column, ]
    right <- switch(row$type, integer = , number = is.numeric(cells), boolean = is.logical(cells),
                    is.character(cells) || is.factor(cells))
    if (!right || any(is.nan(cells[0]))) stop(name, "$", column, " is ", class(cells)[1], ", not ", row$type)
    if (row$type == "integer" && any(cells != round(cells), na.rm = TRUE)) stop(name, "$", column, " is not whole")
    if (is.na(row$missing) || row$missing == "never") stopifnot(!anyNA(cells))
  }
}
for (wrong in list("virtuals", c("run", "pilot"), tables)) {
  stopifnot(inherits(try(answered_trials(wrong), silent = TRUE), "try-error"))
}
stopifnot(nrow(answered_trials("run")) == 0, inherits(try(answered_trials(), silent = TRUE), "try-error"), identical(answered_trials("virtual"), answered_trials(who = "virtual")))

answers <- answered_trials("virtual")
results <- data.frame(protocol = character(), quantity = character(), key = character(), value = numeric())
note <- function(protocol, quantity, key, value) {
  results[nrow(results) + 1, ] <<- list(protocol, quantity, key, as.numeric(value))
}
for (protocol in unique(as.character(answers$protocol))) {
  own <- answers[answers$protocol == protocol, ]
  kind <- as.character(tables$sessions$kind[tables$sessions$protocol == protocol][1])
  first <- own[own$item == min(own$item), ]
  note(protocol, "answers", "", nrow(unique(own[, c("participant", "session", "trial")])))
  interval <- function(quantity, key, hits, n) {
    exact <- binom.test(hits, n)$conf.int
    note(protocol, quantity, key, hits / n)
    note(protocol, paste0(quantity, ".low"), key, exact[1])
    note(protocol, paste0(quantity, ".high"), key, exact[2])
  }
  if (kind == "recognition") interval("correct", "", sum(first$correct), nrow(first))
  if (kind == "selection") {
    chosen <- table(factor(as.character(first$answer)))
    # Each trial offers every item: the worth that fits best to first choices is in proportion to them.
    worth <- log(chosen) - mean(log(chosen))
    for (item in names(chosen)) {
      interval("share", item, chosen[[item]], nrow(first))
      note(protocol, "worth", item, worth[[item]])
    }
  }
}
results$value <- sprintf("%.17g", results$value)
write.csv(results, arguments[2], row.names = FALSE, quote = FALSE)
