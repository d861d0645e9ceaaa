# Loads an export of Asperity with the correct types. Requires no R packages:
#
#   source("import.R", chdir = TRUE)   # from any folder: the path of this file
#   tables$attempts                    # every .tsv and .csv of the folder, by name
#   answers <- answered_trials()       # one row per counted response of a human participant; simulated: "virtual"
#
# Types come from codebook.tsv. Boolean values are TRUE and FALSE; a text with declared levels is a factor;
# missing is NA. In the files, a text that begins with an apostrophe is preceded by a second one, so that
# no spreadsheet reads it as a formula; one apostrophe is removed here.

asperity_folder <- getwd()
if (!file.exists(file.path(asperity_folder, "codebook.tsv"))) {
  stop("there is no codebook.tsv in ", asperity_folder, "; use source(\".../import.R\", chdir = TRUE)")
}

read_asperity_table <- function(path, folder = asperity_folder, described_as = path) {
  codebook <- asperity_codebook(folder)
  codebook <- codebook[codebook$file == described_as, ]
  full <- file.path(folder, path)
  is_csv <- endsWith(path, ".csv")
  cells <- if (is_csv) {
    read.csv(full, colClasses = "character", na.strings = character(), check.names = FALSE, encoding = "UTF-8")
  } else {
    read.delim(full, colClasses = "character", na.strings = character(), quote = "", comment.char = "",
               check.names = FALSE, encoding = "UTF-8")
  }
  missing_as <- if (is_csv) "" else "n/a"
  for (name in names(cells)) {
    told <- codebook[codebook$column == name, ]
    text <- cells[[name]]
    is.na(text) <- !is.na(text) & text == missing_as
    cells[[name]] <- switch(told$type,
      integer = , number = as.numeric(text),
      boolean = text == "1",
      {
        text <- sub("^'", "", text)
        if (told$type == "text" && !is.na(told$levels)) {
          levels <- strsplit(told$levels, " | ", fixed = TRUE)[[1]]
          factor(text, levels = c(levels, setdiff(unique(text[!is.na(text)]), levels)))
        } else text
      })
  }
  cells
}

asperity_codebook <- function(folder = asperity_folder) {
  codebook <- read.delim(file.path(folder, "codebook.tsv"), colClasses = "character", na.strings = "n/a", quote = "",
                         comment.char = "", check.names = FALSE, encoding = "UTF-8")
  for (name in c("description", "levels", "missing")) codebook[[name]] <- sub("^'", "", codebook[[name]])
  codebook
}

read_asperity_tables <- function(folder = asperity_folder) {
  files <- unique(asperity_codebook(folder)$file)
  files <- files[grepl("\\.(tsv|csv)$", files) & !grepl("*", files, fixed = TRUE) & !grepl("/bids/|^bids/", files)]
  files <- setdiff(files, c("codebook.tsv", "MANIFEST.tsv"))
  read <- lapply(files, read_asperity_table, folder = folder)
  names(read) <- gsub("/", "_", sub("\\.(tsv|csv)$", "", files))
  read
}

# Returns one row per answer to a question of a trial, with the trial, the attempt and its conditions. By default these are
# the answers of human participants in study sessions that count in analyses (counts_in_analyses). `who` is "run", "pilot"
# or "virtual"; `counted = FALSE` also returns answers that do not count. Without `who`, an error is raised if there are
# answers, but none of the default ones.
answered_trials <- function(who = "run", counted = TRUE, read = tables) {
  if (!is.character(who) || length(who) != 1 || !(who %in% c("run", "pilot", "virtual"))) {
    stop("answered_trials: who must be \"run\", \"pilot\" or \"virtual\"; for tables of another export use answered_trials(read = ...)")
  }
  keys <- c("participant", "session", "trial", "virtual", "mode")
  answers <- merge(read$responses[!is.na(read$responses$trial), ], read$attempts, by = c(keys, "attempt"))
  answers <- merge(answers, read$trials, by = keys)
  group <- ifelse(answers$virtual, "virtual", as.character(answers$mode))
  kept <- group == who
  if (counted) kept <- kept & answers$counts_in_analyses
  if (missing(who) && nrow(answers) > 0 && !any(kept)) {
    stop("no participant has a response that counts in analyses; the study has responses of the groups ",
         paste0("\"", sort(unique(group)), "\"", collapse = ", "),
         " (", sum(answers$counts_in_analyses), " that count); use answered_trials(\"", sort(unique(group))[1],
         "\") for those of a group, and counted = FALSE to include those that do not count")
  }
  answers <- answers[kept, ]
  answers[order(answers$participant, answers$session, answers$trial, answers$attempt, answers$item), ]
}

tables <- read_asperity_tables()
