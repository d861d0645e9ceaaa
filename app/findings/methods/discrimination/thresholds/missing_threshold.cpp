// Pairs the code of each reason with its sentence; both together determine the side of a missing threshold.

#include "app/findings/methods/discrimination/thresholds/missing_threshold.h"

namespace asperity {

namespace {

WhyNoThreshold every_response_correct() {
  return {"below_levels",
          phrase("MissingThreshold",
                 "every response is correct: the threshold is below the presented levels; present "
                 "smaller differences")};
}

WhyNoThreshold why_not_performance(const Finding& status) {
  if (status.word == "all_correct") return every_response_correct();
  if (status.word == "all_wrong") {
    return {status.word, phrase("MissingThreshold",
                                "no response is correct: check the question and its correct "
                                "response")};
  }
  if (status.word == "not_increasing") {
    return {
        status.word,
        phrase("MissingThreshold",
               "the proportion correct does not increase with the difference from the standard, "
               "as if the responses were guesses: check the responses in the practice and in "
               "catch trials before you present other levels")};
  }
  return {status.word, Phrase(status.status)};
}

WhyNoThreshold why_not_comparison(const Finding& status) {
  if (status.word == "all_correct") {
    return {"below_levels",
            phrase("MissingThreshold",
                   "every response is the one of high levels: the point of subjective equality is "
                   "below the presented levels; present lower levels")};
  }
  if (status.word == "all_wrong") {
    return {"above_levels",
            phrase("MissingThreshold",
                   "every response is the one of low levels: the point of subjective equality is "
                   "above the presented levels; present higher levels")};
  }
  if (status.word == "not_increasing") {
    return {status.word,
            phrase("MissingThreshold",
                   "the proportion of hits does not increase with the level, as if the responses "
                   "were guesses: check the responses in the practice and in catch trials before "
                   "you present other levels")};
  }
  return {status.word, Phrase(status.status)};
}

}  // namespace

SideOfThreshold side_of_threshold(const Finding& threshold) {
  const auto is_for = [&threshold](const WhyNoThreshold& why) {
    return threshold.word == why.word && threshold.status == why.sentence.english();
  };
  // The slope at its bound is the steepest that is fitted, and its JND smaller than every other estimate.
  if (is_for(every_response_correct()) || is_for(threshold_below_levels()) ||
      is_for(slope_at_bound())) {
    return SideOfThreshold::below;
  }
  return is_for(threshold_above_levels()) ? SideOfThreshold::above : SideOfThreshold::unknown;
}

WhyNoThreshold threshold_above_levels() {
  return {"above_levels",
          phrase("MissingThreshold",
                 "the threshold is above the presented levels: present larger differences")};
}

WhyNoThreshold threshold_below_levels() {
  return {"below_levels",
          phrase("MissingThreshold",
                 "the threshold is below the presented levels: present smaller differences")};
}

WhyNoThreshold equality_outside_levels() {
  return {"outside_levels",
          phrase("MissingThreshold",
                 "the point of subjective equality is outside the presented levels: present levels "
                 "on both sides of it")};
}

WhyNoThreshold quartiles_outside_levels() {
  return {"outside_levels",
          phrase("MissingThreshold",
                 "the values at 25 % and 75 % are not both within the presented levels: present a "
                 "wider range of levels")};
}

WhyNoThreshold slope_at_bound() {
  return {"slope_at_bound",
          phrase("MissingThreshold",
                 "the function is steeper than the presented levels can resolve: present levels "
                 "nearer to the threshold")};
}

WhyNoThreshold slope_at_limit() {
  return {"slope_at_limit", phrase("MissingThreshold",
                                   "the slope is at a limit of the fit, because the responses do "
                                   "not determine it: add trials")};
}

WhyNoThreshold threshold_at_end_of_prior() {
  return {"at_end_of_prior",
          phrase("MissingThreshold",
                 "more than 5 % of the posterior probability is at an end of the range of "
                 "thresholds of the prior: widen the range, and present levels in it")};
}

WhyNoThreshold why_not_fitted(const DiscriminationTask& task, const Finding* status) {
  if (status == nullptr || status->word == "ok") {
    return {"not_defined",
            phrase("MissingThreshold",
                   "no threshold is defined for these data: add trials at several levels")};
  }
  return task.is_performance ? why_not_performance(*status) : why_not_comparison(*status);
}

}  // namespace asperity
