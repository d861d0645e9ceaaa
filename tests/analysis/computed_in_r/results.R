# Writes the numbers that a test expects: quantity,key,value with 15 significant digits.
options(digits = 15, stringsAsFactors = FALSE, warn = 1)
RNGkind("Mersenne-Twister", "Inversion", "Rejection")

results <- character()
row <- function(quantity, key, value) results[[length(results) + 1]] <<- paste(quantity, key, sprintf("%.15g", value), sep = ",")
rows <- function(quantity, keys, values) for (i in seq_along(keys)) row(quantity, keys[i], values[[i]])
write_results <- function(file) writeLines(c("quantity,key,value", unlist(results)), file)
write_data <- function(data, file) write.csv(data, file, row.names = FALSE, quote = FALSE, na = "")
