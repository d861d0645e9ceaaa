# Recomputes the tables of tests of a study from its export, with R alone. Arguments: the folder of the export, a CSV of what the
# protocols declare (protocol, family, target, condition, conditions; lists are separated by ";"), the file to write. Distributions are R's own; null
# distributions are those that docs/analysis.md describes, counted in full whatever the program counts or draws, but for
# the responses of a recognition, which are permuted at random.
options(warn = 2)
arguments <- commandArgs(trailingOnly = TRUE)
source(file.path(arguments[1], "import.R"), chdir = TRUE)
declared <- read.csv(arguments[2], colClasses = "character")
confidence <- 0.95
tail <- (1 - confidence) / 2
trial_keys <- c("participant", "session", "trial", "attempt")

results <- list()
note <- function(test, about, quantity, value) {
  if (length(value) != 1 || is.na(value)) return(invisible())
  results[[length(results) + 1]] <<- data.frame(protocol = where[1], group = where[2], test = test, about = about,
                                                quantity = quantity, value = sprintf("%.17g", value))
}
# A row of the table. effect: the value, its lower and its upper limit. smallest: the smallest attainable p, where not every p is.
family <- list(p = numeric(), smallest = numeric())
into_family <- function(test, about, p, smallest) {
  name <- paste(test, about, sep = "\t")
  family$p[[name]] <<- p
  family$smallest[[name]] <<- smallest
}
note_smallest <- function(test, about, smallest) if (!is.na(smallest) && smallest > 0.05) note(test, about, "p_smallest", smallest)
test_row <- function(test, about, statistic, p, n, effect = c(NA, NA, NA), df = numeric(), smallest = NA, left_out = 0) {
  note(test, about, "value", statistic)
  note(test, about, "p", p)
  note(test, about, "n", n)
  note(test, about, "left_out", left_out)
  for (i in seq_along(df)) note(test, about, paste0("df", i), df[i])
  for (i in 1:3) note(test, about, c("effect", "effect_low", "effect_high")[i], effect[i])
  if (test %in% of_family) into_family(test, about, p, smallest) else note_smallest(test, about, smallest)
}
# A declared test that cannot be made counts as p = 1, and has no corrected p.
no_test <- function(test, about) if (test %in% of_family) into_family(test, about, NA, 1)

# --- null distributions ----------------------------------------------------------------------------------------------

# A distribution of whole numbers: the least of them, and the probabilities of it and its successors.
counted <- function(values) {
  low <- min(values)
  list(low = low, p = tabulate(values - low + 1) / length(values))
}
plus <- function(a, b) {
  p <- numeric(length(a$p) + length(b$p) - 1)
  for (i in seq_along(a$p)) p[i - 1 + seq_along(b$p)] <- p[i - 1 + seq_along(b$p)] + a$p[i] * b$p
  list(low = a$low + b$low, p = p)
}
values_of <- function(d) d$low + seq_along(d$p) - 1
at_least <- function(d, observed) sum(d$p[values_of(d) >= observed])

permutations <- function(n) {
  if (n == 1) return(matrix(1L, 1, 1))
  shorter <- permutations(n - 1)
  do.call(rbind, lapply(seq_len(n), function(first) cbind(first, shorter + (shorter >= first), deparse.level = 0)))
}

# Every pattern of signs is equally likely.
sign_flips <- function(differences) {
  d <- differences[differences != 0]
  if (!length(d)) return(c(p = 1, smallest = 1))
  null <- Reduce(plus, lapply(d, function(one) counted(c(one, -one))))
  c(p = sum(null$p[abs(values_of(null)) >= abs(sum(d))]), smallest = 2 / 2^length(d))
}

# The counts of every row are exchanged among the labels: the distribution of all totals together.
exchanged_labels <- function(counts) {
  orders <- permutations(ncol(counts))
  base <- (sum(counts) + 1)^(seq_len(ncol(counts)) - 1)
  totals <- matrix(0, 1, ncol(counts))
  p <- 1
  for (i in seq_len(nrow(counts))) {
    moved <- matrix(counts[i, ][orders], nrow(orders))
    now <- totals[rep(seq_len(nrow(totals)), each = nrow(moved)), , drop = FALSE] +
      moved[rep(seq_len(nrow(moved)), nrow(totals)), , drop = FALSE]
    key <- drop(now %*% base)
    first <- !duplicated(key)
    p <- rowsum(rep(p / nrow(moved), each = nrow(moved)), key, reorder = FALSE)[, 1]
    totals <- now[first, , drop = FALSE]
  }
  squares <- rowSums(totals^2)
  alike <- sum(colSums(t(apply(counts, 1, sort)))^2)
  c(p = sum(p[squares >= sum(colSums(counts)^2)]), smallest = sum(p[squares >= alike]))
}

# All ways to split the participants into groups of these sizes, by how many of them have which sum of whole numbers.
split_into_groups <- function(first, second) {
  n1 <- length(first)
  n2 <- length(second)
  all <- c(first, second)
  ways <- matrix(0, n1 + 1, sum(all) + 1)
  ways[1, 1] <- 1
  for (value in all) for (size in n1:1) {
    ways[size + 1, ] <- ways[size + 1, ] + c(numeric(value), ways[size, seq_len(ncol(ways) - value)])
  }
  sums <- seq_len(ncol(ways)) - 1
  apart <- abs(sums * n2 - (sum(all) - sums) * n1)
  sum(ways[n1 + 1, apart >= abs(sum(first) * n2 - sum(second) * n1)]) / choose(n1 + n2, n1)
}

# --- effect sizes ----------------------------------------------------------------------------------------------------

# The noncentralities for which t lies on the limits of what is likely. P(Z + ncp <= t s) over the distribution of s = sqrt(chi2 / df):
# pt itself loses digits.
noncentral_t <- function(t, df) {
  below <- function(ncp) integrate(function(s) pnorm(t * s - ncp) * 2 * df * s * dchisq(df * s^2, df), 0, 1 + 12 / sqrt(df),
                                   rel.tol = 1e-11, subdivisions = 1000)$value
  width <- 12 * sqrt(1 + t^2 / (2 * df))
  sapply(c(1 - tail, tail), function(p) uniroot(function(ncp) below(ncp) - p, t + c(-1, 1) * width, tol = 1e-11)$root)
}
has_spread <- function(x) length(x) > 1 && var(x) > 1e-20
cohen_d <- function(x, null = 0) {
  if (!has_spread(x)) return(c(NA, NA, NA))
  d <- (mean(x) - null) / sd(x)
  c(d, noncentral_t(d * sqrt(length(x)), length(x) - 1) / sqrt(length(x)))
}
hedges_g <- function(a, b) {
  df <- length(a) + length(b) - 2
  if (min(length(a), length(b)) < 2 || var(a) + var(b) < 1e-20) return(c(NA, NA, NA))
  d <- (mean(a) - mean(b)) / sqrt(((length(a) - 1) * var(a) + (length(b) - 1) * var(b)) / df)
  root <- sqrt(1 / (1 / length(a) + 1 / length(b)))
  exp(lgamma(df / 2) - lgamma((df - 1) / 2)) / sqrt(df / 2) * c(d, noncentral_t(d * root, df) / root)
}
cohen_h <- function(hits, n, chance) {
  wilson <- suppressWarnings(prop.test(hits, n, correct = FALSE)$conf.int)
  2 * asin(sqrt(c(hits / n, wilson))) - 2 * asin(sqrt(chance))
}
# W of the participants' ranks; from ten participants on with the jackknife of the mean rank correlation of two, as Fisher's z.
kendall_w <- function(counts) {
  concordance <- function(rows) {
    ranks <- t(apply(rows, 1, rank)) - (ncol(rows) + 1) / 2
    if (sum(ranks^2) == 0) NA else sum(colSums(ranks)^2) / (nrow(rows) * sum(ranks^2))
  }
  n <- nrow(counts)
  if (n < 2) return(c(NA, NA, NA))
  w <- concordance(counts)
  z <- function(rows) {
    r <- (nrow(rows) * concordance(rows) - 1) / (nrow(rows) - 1)
    if (is.na(r) || abs(r) >= 1) NA else atanh(r)
  }
  parts <- sapply(seq_len(n), function(i) z(counts[-i, , drop = FALSE]))
  if (n < 10 || anyNA(c(z(counts), parts))) return(c(w, NA, NA))
  pseudo <- n * z(counts) - (n - 1) * parts
  ends <- mean(pseudo) + c(-1, 1) * qt(1 - tail, n - 1) * sd(pseudo) / sqrt(n)
  c(w, pmax(0, (1 + (n - 1) * tanh(ends)) / n))
}
# P(k fixed points) in proportion to its probability under chance times exp(theta k); theta by profile likelihood.
mallows_theta <- function(right, items) {
  chance <- counted(rowSums(permutations(items) == rep(seq_len(items), each = factorial(items))))
  k <- values_of(chance)
  log_sum <- function(theta) log(sum(chance$p * exp(theta * k)))
  if (mean(right) %in% c(0, items)) return(c(NA, NA, NA))
  log_likelihood <- function(theta) sum(right) * theta - length(right) * log_sum(theta)
  mean_at <- function(theta) sum(k * chance$p * exp(theta * k - log_sum(theta)))
  best <- uniroot(function(theta) mean_at(theta) - mean(right), c(-40, 40), tol = 1e-13)$root
  drop <- function(theta) 2 * (log_likelihood(best) - log_likelihood(theta)) - qchisq(confidence, 1)
  c(best, uniroot(drop, c(best - 60, best), tol = 1e-13)$root, uniroot(drop, c(best, best + 60), tol = 1e-13)$root)
}

# --- the kinds -------------------------------------------------------------------------------------------------------

count_by <- function(rows, columns, of) {
  as.matrix(unclass(table(factor(of$participant[rows], people), columns[rows])))
}
within_participants <- function(test, about, counts, participants = nrow(counts)) {
  kept <- counts[rowSums(counts) > 0, , drop = FALSE]
  if (nrow(kept) < 2) return(no_test(test, about))
  totals <- colSums(kept)
  null <- exchanged_labels(kept)
  test_row(test, about, sum((totals - mean(totals))^2) / mean(totals), null["p"], nrow(kept), kendall_w(kept),
           smallest = null["smallest"], left_out = if (test == "textures") participants - nrow(kept) else 0)
}

selection <- function(answers, felt, of) {
  answers$trial_id <- do.call(paste, answers[trial_keys])
  felt <- felt[order(felt$trial_id, felt$position), ]
  offered <- split(felt$item, felt$trial_id)[answers$trial_id]
  items <- sort(unique(felt$item))
  choice <- as.character(answers$answer)
  choice[!mapply(`%in%`, choice, offered)] <- NA
  all_offered <- all(lengths(lapply(offered, unique)) == length(items))
  texture <- felt$texture[match(answers$trial_id, felt$trial_id)]
  place <- mapply(match, choice, offered)
  for (pair in combn(items, 2, simplify = FALSE)) {
    rows <- sapply(offered, function(one) all(pair %in% one))
    if (!any(rows)) next
    counts <- count_by(rows, factor(choice, if (all_offered) items else pair), answers)
    counts <- counts[rowSums(counts) > 0, , drop = FALSE]
    test <- if ("target_pairs" %in% of_family && of$target %in% pair) "target_pairs" else "pairs"
    about <- paste(pair, collapse = " / ")
    if (nrow(counts) < 2) { no_test(test, about); next }
    difference <- counts[, pair[1]] - counts[, pair[2]]
    null <- sign_flips(difference)
    test_row(test, about, sum(difference), null["p"], nrow(counts), cohen_d(difference), smallest = null["smallest"])
  }
  everywhere <- rep(TRUE, nrow(answers))
  if (all_offered) within_participants("preference", "", count_by(everywhere, factor(choice, items), answers))
  sizes <- unique(lengths(offered))
  if (length(sizes) == 1 && sizes > 1) {
    within_participants("position", "", count_by(everywhere, factor(place, seq_len(sizes)), answers))
  }
  if (of$target %in% items && all_offered && length(unique(texture)) > 1) {
    trials <- count_by(everywhere, factor(texture), answers)
    if (all(trials == trials[, 1])) {
      within_participants("textures", "", count_by(choice %in% of$target, factor(texture), answers))
    }
  }
}

of_groups <- function(means) {
  sex <- tables$participants$sex[match(names(means), tables$participants$participant)]
  a <- means[sex %in% "F"]
  b <- means[sex %in% "M"]
  if (!length(a) || !length(b)) return(no_test("sexes", "F / M"))
  whole <- 2520  # a multiple of every number of trials up to ten
  stopifnot(all(abs(c(a, b) * whole - round(c(a, b) * whole)) < 1e-6))
  numbers <- round(c(a, b) * whole)
  divisor <- Reduce(function(x, y) { while (y > 0) { r <- x %% y; x <- y; y <- r }; x }, c(whole, numbers))
  test_row("sexes", "F / M", mean(a) - mean(b),
           split_into_groups(round(a * whole / divisor), round(b * whole / divisor)), length(a) + length(b), hedges_g(a, b))
}

matching <- function(answers, felt, of) {
  felt$id <- paste(felt$trial_id, felt$position)
  answers$trial_id <- do.call(paste, answers[trial_keys])
  rows <- felt[match(paste(answers$trial_id, answers$item), felt$id), ]
  answers$felt <- rows$item
  answers$given <- as.character(answers$answer)
  pictures <- sort(unique(answers$felt))
  m <- length(pictures)
  orders <- permutations(m)
  trial_right <- tapply(answers$felt == answers$given, answers$trial_id, sum)
  of_participant <- lapply(split(answers, factor(answers$participant, people)), function(own) {
    # How often each picture was given to each texture; relabelled pictures count along the diagonal of that table.
    table <- unclass(table(factor(own$felt, pictures), factor(own$given, pictures)))
    by_texture <- sapply(seq_len(m), function(felt) table[felt, orders[, felt]])
    kinds <- table(vapply(split(own, own$trial_id), function(trial)
      paste(match(trial$given[match(pictures, trial$felt)], pictures), collapse = " "), ""))
    list(right = counted(rowSums(by_texture)),
         whole = counted(as.vector(sapply(apply(orders, 1, paste, collapse = " "), function(order)
           if (order %in% names(kinds)) kinds[[order]] else 0))),
         textures = lapply(seq_len(m), function(felt) counted(by_texture[, felt])))
  })
  above <- function(test, about, part, observed, effect) {
    null <- Reduce(plus, lapply(of_participant, part))
    reachable <- max(which(null$p > 0))
    smallest <- null$p[reachable]
    if (length(people) < 2 && smallest > 1 - 1e-9) return(no_test(test, about))
    if (length(people) < 2) effect[2:3] <- NA  # an interval of one participant's trials is none over participants
    test_row(test, about, observed, at_least(null, observed), length(people), effect, smallest = smallest)
  }
  above("items", "", function(own) own$right, sum(trial_right), mallows_theta(trial_right, m))
  above("whole", "", function(own) own$whole, sum(trial_right == m), cohen_h(sum(trial_right == m), length(trial_right), 1 / factorial(m)))
  for (i in seq_along(pictures)) {
    own <- answers[answers$felt == pictures[i], ]
    hits <- sum(own$given == pictures[i])
    above("textures", pictures[i], function(one) one$textures[[i]], hits, cohen_h(hits, nrow(own), 1 / m))
  }
  of_groups(tapply(trial_right, sub(" .*", "", names(trial_right)), mean))
}

recognition <- function(answers, felt, of) {
  answers$trial_id <- do.call(paste, answers[trial_keys])
  answers$felt <- felt$item[match(answers$trial_id, felt$trial_id)]
  labels <- sort(setdiff(unlist(strsplit(gsub("[][\"]", "", unique(answers$options_json)), ",")), "cannot_tell"))
  m <- length(labels)
  own <- tapply(answers$correct, answers$participant, mean)
  d <- cohen_d(own, 1 / m)
  if (!is.na(d[1])) {
    t <- t.test(own, mu = 1 / m)
    test_row("right", "", t$statistic, t$p.value, length(own), d, t$parameter)
  } else if (length(own) == 1) {
    binomial("right", "", sum(answers$correct), nrow(answers), m)
  } else no_test("right", "")
  counts <- unclass(table(factor(answers$felt, labels), factor(as.character(answers$answer), labels)))
  n <- sum(counts)
  expected <- outer(rowSums(counts), colSums(counts)) / n
  g <- 2 * sum((counts * log(counts / expected))[counts > 0])
  df <- (sum(rowSums(counts) > 0) - 1) * (sum(colSums(counts) > 0) - 1)
  # Without degrees of freedom no hypothesis is tested. G has the order of the sum of n log n over the cells.
  if (df > 0) {
    who <- as.integer(factor(answers$participant))
    row <- match(answers$felt, labels)[order(who)]
    column <- match(as.character(answers$answer), labels)
    sum_of <- function(order) {
      cells <- tabulate(row + m * (column[order] - 1), m * m)
      sum((cells * log(cells))[cells > 0])
    }
    set.seed(1)
    observed <- sum_of(order(who)) * (1 - 1e-12)
    permuted <- replicate(50000, sum_of(order(who, runif(n))))
    all_sums <- c(observed, permuted)
    smallest <- mean(all_sums >= max(all_sums) * (1 - 1e-12))
    test_row("information", "", g, mean(c(TRUE, permuted >= observed)), n, c((g - df) / (2 * n * log(2)), NA, NA), df, smallest)
  } else no_test("information", "")
  for (label in labels) if (sum(counts[label, ])) binomial("textures", label, counts[label, label], sum(counts[label, ]), m)
  of_groups(own)
}
binomial <- function(test, about, hits, n, m) {
  test_row(test, about, hits, binom.test(hits, n, 1 / m, alternative = "greater")$p.value, n, cohen_h(hits, n, 1 / m))
}

magnitude <- function(answers, felt, of) {
  data <- data.frame(person = factor(answers$participant),
                     spacing = factor(answers$texture_spacing_m, sort(unique(answers$texture_spacing_m))),
                     condition = if (nzchar(of$condition)) factor(answers[[paste0("factor_", of$condition)]], strsplit(of$conditions, ";")[[1]]) else factor("all"),
                     y = log10(answers$answer_number))
  cells <- aggregate(y ~ person + condition + spacing, data, mean)
  complete <- names(which(table(cells$person) == nlevels(data$condition) * nlevels(data$spacing)))
  cells <- droplevels(cells[cells$person %in% complete, ])
  n <- nlevels(cells$person)
  if (n < 2) return(invisible())
  several <- nlevels(cells$condition) > 1
  strata <- if (several) summary(aov(y ~ condition * spacing + Error(person / (condition * spacing)), cells)) else
    summary(aov(y ~ spacing + Error(person / spacing), cells))
  names(strata) <- sub("^Error: ", "", names(strata))
  squares <- function(stratum, row) strata[[stratum]][[1]][row, "Sum Sq"]
  effects <- c(if (several) c(condition = "person:condition"), spacing = "person:spacing",
               if (several) c(interaction = "person:condition:spacing"))
  errors <- sum(sapply(effects, squares, 2))  # the modulus is free: the scales of the participants are removed
  y <- with(cells, tapply(y, list(person, interaction(condition, spacing, lex.order = TRUE)), mean))
  scaled <- function(levels) { h <- contr.helmert(levels); sweep(h, 2, sqrt(colSums(h^2)), "/") }
  average <- function(levels) matrix(1 / sqrt(levels), levels, 1)
  conditions <- nlevels(cells$condition)
  spacings <- nlevels(cells$spacing)
  contrasts <- list(spacing = kronecker(average(conditions), scaled(spacings)))
  if (several) contrasts <- c(contrasts, list(condition = kronecker(scaled(conditions), average(spacings)),
                                              interaction = kronecker(scaled(conditions), scaled(spacings))))
  for (effect in names(effects)) {
    row <- strata[[effects[[effect]]]][[1]]
    f <- row[1, "F value"]
    df <- row[, "Df"]
    covariance <- cov(y %*% contrasts[[effect]])
    epsilon <- sum(diag(covariance))^2 / (df[1] * sum(covariance^2))
    corrected <- df * epsilon
    error <- squares(effects[[effect]], 2)
    limit <- function(p) {
      if (pf(f, corrected[1], corrected[2]) < p) return(0)
      ncp <- uniroot(function(ncp) pf(f, corrected[1], corrected[2], ncp) - p, c(0, 10 * f * corrected[1] + 50), tol = 1e-11)$root
      # partial eta squared as odds, then with the other error strata as they were observed
      odds <- ncp / (sum(corrected) + 1)
      odds / (odds + errors / error)
    }
    ss <- squares(effects[[effect]], 1)
    test_row(effect, "", f, pf(f, corrected[1], corrected[2], lower.tail = FALSE), n,
             c(ss / (ss + errors), limit(1 - tail), limit(tail)), df)
  }
  peaks(cells, n)
}

# The spacing at which the mean of the participants' parabolas is greatest, and its ratio between two conditions.
peaks <- function(cells, n) {
  curves <- lapply(split(cells, cells$condition), function(own) t(sapply(split(own, own$person), function(one)
    coef(lm(y ~ x + I(x^2), data.frame(y = one$y, x = log10(as.numeric(as.character(one$spacing)))))))))
  x <- range(log10(as.numeric(levels(cells$spacing))))
  is_interior <- sapply(curves, function(coefficients) {
    slopes <- apply(coefficients, 1, function(b) b[2] + 2 * b[3] * x)
    max(t.test(slopes[1, ], alternative = "greater")$p.value, t.test(slopes[2, ], alternative = "less")$p.value) < 0.05
  })
  for (pair in combn(names(curves), min(2, length(curves)), simplify = FALSE)) if (length(pair) == 2) {
    top <- sapply(curves[pair], function(b) -mean(b[, 2]) / (2 * mean(b[, 3])))
    if (!all(sapply(curves[pair], function(b) mean(b[, 3]) < 0))) next
    # of the difference of both peaks -b / (2 c), by the two b and c
    gradient <- unlist(lapply(curves[pair], function(b) c(-1, mean(b[, 2]) / mean(b[, 3])) / (2 * mean(b[, 3])))) * c(1, 1, -1, -1)
    variance <- drop(gradient %*% (cov(do.call(cbind, lapply(curves[pair], function(b) b[, 2:3]))) / n) %*% gradient)
    about <- paste(pair, collapse = " / ")
    if (!all(is_interior[pair])) { no_test("peaks", about); next }
    apart <- top[[1]] - top[[2]]
    test_row("peaks", about, apart / sqrt(variance), 2 * pt(-abs(apart) / sqrt(variance), n - 1), n,
             10^(apart + c(0, -1, 1) * qt(1 - tail, n - 1) * sqrt(variance)), n - 1)
  }
}

# --- every protocol and group ----------------------------------------------------------------------------------------

tables$presentations$trial_id <- do.call(paste, tables$presentations[trial_keys])
for (group in c("run", "pilot", "virtual")) {
  of_group <- answered_trials(group)
  for (protocol in unique(as.character(of_group$protocol))) {
    answers <- of_group[of_group$protocol == protocol & of_group$phase == "main" & of_group$repetition > 0, ]
    if (!nrow(answers)) next
    people <- sort(unique(answers$participant))
    ids <- do.call(paste, answers[trial_keys])
    felt <- tables$presentations[tables$presentations$trial_id %in% ids, ]
    of <- declared[declared$protocol == protocol, ]
    if (!nrow(of)) next
    of_family <- strsplit(of$family, ";")[[1]]
    where <- c(protocol, c(run = "people", pilot = "pilot", virtual = "virtual")[[group]])
    family <- list(p = numeric(), smallest = numeric())
    kind <- as.character(tables$sessions$kind[tables$sessions$protocol == protocol][1])
    get(kind)(answers, felt, of)
    corrected <- p.adjust(ifelse(is.na(family$p), 1, family$p), "holm")
    # What the corrected p could be at least: 0 stands for a test of which every p is possible.
    smallest <- p.adjust(ifelse(is.na(family$smallest), 0, family$smallest), "holm")
    for (name in names(family$p)[!is.na(family$p)]) {
      parts <- strsplit(paste0(name, "\t"), "\t")[[1]]
      about <- if (length(parts) > 1) parts[2] else ""
      note(parts[1], about, "p_holm", corrected[[name]])
      if (!is.na(family$smallest[[name]])) note_smallest(parts[1], about, smallest[[name]])
    }
  }
}
write.csv(do.call(rbind, results), arguments[3], row.names = FALSE)
