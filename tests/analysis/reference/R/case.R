# Writes a case: rows of results, the table, case.json. Base R only.
options(digits = 15, stringsAsFactors = FALSE, warn = 1)
RNGkind("Mersenne-Twister", "Inversion", "Rejection")

# How well a number can be known: counts, formulas, tails, optima, curvatures at optima.
tolerances <- list(count = c(0, 0), formula = c(1e-10, 1e-12), tail = c(1e-8, 1e-300),
                   optimum = c(1e-6, 1e-7), curvature = c(1e-4, 1e-6))
results <- list()

text_of <- function(value) {
  if (is.character(value)) return(value)
  if (is.logical(value) && !is.na(value)) return(if (value) "TRUE" else "FALSE")
  if (is.na(value)) return("NA")
  if (is.infinite(value)) return(if (value > 0) "Inf" else "-Inf")
  if (value == 0) "0" else sprintf("%.15g", value)
}
quoted <- function(text) ifelse(grepl("[,\"]", text), paste0("\"", gsub("\"", "\"\"", text), "\""), text)

row <- function(quantity, key, value, known = "formula") {
  stopifnot(length(value) == 1)
  tolerance <- tolerances[[known]]
  line <- paste(quoted(quantity), quoted(as.character(key)), quoted(text_of(value)),
                format(tolerance[1]), format(tolerance[2]), sep = ",")
  results[[length(results) + 1]] <<- line
}
rows <- function(quantity, keys, values, known = "formula")
  for (i in seq_along(keys)) row(quantity, keys[i], values[[i]], known)

write_table <- function(data, file) write.csv(data, file, row.names = FALSE, quote = FALSE, na = "")
read_table <- function(file) read.csv(file, na.strings = c("", "NA"), colClasses = "character")
json_text <- function(x) paste0("\"", x, "\"")
json_list <- function(x) paste0("[", paste(if (is.character(x)) json_text(x) else format(x), collapse = ", "), "]")

# options: a named character vector of JSON values.
write_case <- function(family, title, inputs, options = character()) {
  body <- paste0("    ", json_text(names(options)), ": ", options, collapse = ",\n")
  writeLines(c("{", paste0("  \"family\": ", json_text(family), ","),
               paste0("  \"title\": ", json_text(title), ","),
               paste0("  \"inputs\": ", if (length(inputs) == 1) json_text(inputs) else json_list(inputs), ","),
               if (length(options)) c("  \"options\": {", body, "  }") else "  \"options\": []", "}"), "case.json")
}
write_results <- function() writeLines(c("quantity,key,value,rtol,atol", unlist(results)), "expected.csv")

# The Wilson interval as the two roots of (p - k/n)^2 = z^2 p (1 - p) / n.
wilson <- function(k, n, confidence) {
  z <- qnorm(0.5 + confidence / 2); p <- k / n
  a <- 1 + z^2 / n; b <- -(2 * p + z^2 / n); root <- sqrt(b^2 - 4 * a * p^2)
  c(if (k == 0) 0 else (-b - root) / (2 * a), if (k == n) 1 else (-b + root) / (2 * a))
}
clopper_pearson <- function(k, n, confidence) {
  error <- (1 - confidence) / 2
  c(if (k == 0) 0 else qbeta(error, k, n - k + 1), if (k == n) 1 else qbeta(1 - error, k + 1, n - k))
}
# All permutations of 1..n, one per row.
permutations <- function(n) {
  if (n == 1) return(matrix(1, 1, 1))
  shorter <- permutations(n - 1)
  do.call(rbind, lapply(1:n, function(first) cbind(first, ifelse(shorter >= first, shorter + 1, shorter))))
}
# Sums of independent whole numbers: a named vector of probabilities, the names are the values.
sum_of <- function(a, b) {
  values <- outer(as.numeric(names(a)), as.numeric(names(b)), "+")
  tapply(as.vector(outer(a, b)), factor(values), sum)
}
# Two-sided p of the sum of d when each sign is a coin's, all 2^n patterns counted.
sign_flip <- function(d) {
  d <- d[d != 0]
  if (!length(d)) return(1)
  sums <- c("0" = 1)
  for (one in d) sums <- sum_of(sums, setNames(c(.5, .5), c(-one, one)))
  sum(sums[abs(as.numeric(names(sums))) >= abs(sum(d)) - 1e-9])
}
# The place of the largest value of f: a general optimiser, then Newton's method with numerical derivatives (package numDeriv).
largest <- function(f, start) {
  x <- start
  for (i in 1:3) x <- optim(x, function(x) -f(x), method = "BFGS", control = list(reltol = 1e-15, maxit = 1000))$par
  for (i in 1:6) x <- x - as.numeric(solve(numDeriv::hessian(f, x), numDeriv::grad(f, x)))
  x
}
curvature <- function(f, x) solve(-numDeriv::hessian(f, x))
# Whether steps along TRUE cells lead from every place to every other one.
all_reach_all <- function(step) { reach <- step | diag(nrow(step)) > 0; for (i in seq_len(nrow(step))) reach <- (reach %*% reach) > 0; all(reach) }
