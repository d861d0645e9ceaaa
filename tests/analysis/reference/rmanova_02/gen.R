source("../R/case.R"); source("../R/rmanova.R")
# Three unequal groups, sums of squares of type 3, one group with a single participant.
set.seed(42); within <- list(speed = c("20", "50", "80")); between <- list(hand = c("left", "right", "both")); people <- rep(between$hand, c(4, 5, 1))
data <- do.call(rbind, lapply(1:10, function(i) data.frame(subject = paste0("P", i), hand = people[i], speed = within$speed, y = round(rnorm(1, 0, .3) + (1:3) * .2 * (people[i] == "left") + rnorm(3, 0, .3), 3))))
write_table(data, "data.csv")
write_case("rmanova", "three unequal groups, type 3", "data.csv",
           c(within = "{ \"speed\": [\"20\", \"50\", \"80\"] }", between = "{ \"hand\": [\"left\", \"right\", \"both\"] }", trend = json_text("speed"), trend_scale = json_text("linear"), conf = "0.9"))
rmanova_results(data, within, between, trend = "speed", confidence = .9)
write_results()
