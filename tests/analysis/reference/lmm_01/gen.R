source("../R/case.R"); source("../R/lmm.R")
# Contact times of unequally many trials, three textures, a trend; two trials without a time.
set.seed(61); n <- c(6, 9, 4, 12, 8, 7)
data <- data.frame(subject = rep(paste0("P", 1:6), n), trial = unlist(lapply(n, seq_len)))
data$texture <- c("wood", "metal", "cloth")[(seq_len(nrow(data)) * 7) %% 3 + 1]
data$y <- round(exp(1 + rnorm(6, 0, .3)[as.integer(sub("P", "", data$subject))] + c(wood = 0, metal = .25, cloth = -.1)[data$texture] - .04 * data$trial + rnorm(nrow(data), 0, .35)), 3)
data$y[c(5, 20)] <- NA
data <- data[order(data$texture != data$texture[1]), ]  # not sorted by participant
write_table(data, "data.csv")
levels <- unique(data$texture[!is.na(data$y)])
write_case("lmm", "times of unequally many trials: a factor with three levels and a covariate", "data.csv",
           c(fixed = paste0("{ \"texture\": ", json_list(levels), " }"), covariates = json_text("trial"), scale = json_text("log"), conf = "0.9"))
lmm_results(data, "texture", "trial", "log", 0.9)
write_results()
