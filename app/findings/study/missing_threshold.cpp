#include "app/findings/study/missing_threshold.h"

namespace asperity {

namespace {

WhyNoThreshold why_not_performance(const Finding& status) {
  if (status.word == "all_correct") {
    return {"below_levels",
            "every response is correct: the threshold is below the presented levels; present "
            "smaller differences"};
  }
  if (status.word == "all_wrong") {
    return {status.word, "every response is incorrect: present larger differences"};
  }
  if (status.word == "not_increasing") {
    return {status.word,
            "the proportion correct does not increase with the difference from the standard: "
            "present larger differences"};
  }
  return {status.word, status.status};
}

WhyNoThreshold why_not_comparison(const Finding& status) {
  if (status.word == "all_correct") {
    return {"below_levels",
            "every response is the one of high levels: the point of subjective equality is below "
            "the presented levels; present lower levels"};
  }
  if (status.word == "all_wrong") {
    return {"above_levels",
            "every response is the one of low levels: the point of subjective equality is above "
            "the presented levels; present higher levels"};
  }
  if (status.word == "not_increasing") {
    return {status.word,
            "the proportion of hits does not increase with the level: present a wider range of "
            "levels"};
  }
  return {status.word, status.status};
}

}  // namespace

WhyNoThreshold threshold_outside_levels() {
  return {"outside_levels",
          "the threshold is outside the presented levels: present levels around it"};
}

WhyNoThreshold equality_outside_levels() {
  return {"outside_levels",
          "the point of subjective equality is outside the presented levels: present levels around "
          "it"};
}

WhyNoThreshold quartiles_outside_levels() {
  return {"outside_levels",
          "the values at 25 % and 75 % are not both within the presented levels: present a wider "
          "range of levels"};
}

WhyNoThreshold slope_at_bound() {
  return {"slope_at_bound",
          "the function is steeper than the presented levels can resolve: present levels nearer to "
          "the threshold"};
}

WhyNoThreshold slope_at_limit() {
  return {"slope_at_bound",
          "the slope is at a limit of the fit: present more trials, at levels on both sides of the "
          "threshold"};
}

WhyNoThreshold why_not_fitted(const DiscriminationTask& task, const Finding* status) {
  if (status == nullptr || status->word == "ok") {
    return {"not_defined", "no threshold is defined for these data"};
  }
  return task.is_performance ? why_not_performance(*status) : why_not_comparison(*status);
}

}  // namespace asperity
