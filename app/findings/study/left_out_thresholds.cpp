#include "app/findings/study/left_out_thresholds.h"

#include <cstddef>
#include <string_view>

#include "app/findings/reading_number.h"
#include "app/findings/study/missing_threshold.h"

namespace asperity {

namespace {

/// Estimates of a threshold that means leave out, by the side of the presented levels on which they lie.
struct LeftOutThresholds {
  std::size_t of = 0;
  std::size_t below = 0;
  std::size_t above = 0;
};

LeftOutThresholds left_out_thresholds(const std::vector<Finding>& thresholds,
                                      std::string_view quantity) {
  LeftOutThresholds left_out{};
  for (const Finding& finding : thresholds) {
    if (finding.analysis != kThresholds || finding.quantity != quantity) continue;
    ++left_out.of;
    if (finding.value) continue;
    const SideOfThreshold side = side_of_threshold(finding);
    left_out.below += side == SideOfThreshold::below ? 1 : 0;
    left_out.above += side == SideOfThreshold::above ? 1 : 0;
  }
  return left_out;
}

}  // namespace

Phrase with_left_out_thresholds(Phrase answer, const DiscriminationResults& results) {
  const LeftOutThresholds left_out =
      left_out_thresholds(results.fit.thresholds, results.quantity_of_threshold());
  const auto add = [&](const Phrase& sentence, std::size_t count) {
    answer = sentence.with(answer, std::to_string(count), std::to_string(left_out.of));
  };
  const bool has_conditions = results.conditions.size() > 1;
  if (left_out.below > 0) {
    add(has_conditions
            ? phrase("Analysis",
                     "%1 Left out: %2 of %3 thresholds (participants by conditions), which are "
                     "below the presented levels; the means are too high.")
            : phrase("Analysis",
                     "%1 Left out: %2 of %3 participants, whose threshold is below the presented "
                     "levels; the mean is too high."),
        left_out.below);
  }
  if (left_out.above > 0) {
    add(has_conditions
            ? phrase("Analysis",
                     "%1 Left out: %2 of %3 thresholds (participants by conditions), which are "
                     "above the presented levels; the means are too low.")
            : phrase("Analysis",
                     "%1 Left out: %2 of %3 participants, whose threshold is above the presented "
                     "levels; the mean is too low."),
        left_out.above);
  }
  return answer;
}

std::string bias_sentences(const std::vector<Finding>& findings, const std::string& quantity,
                           const std::string& measure) {
  const LeftOutThresholds left_out = left_out_thresholds(findings, quantity);
  if (left_out.below + left_out.above == left_out.of) return {};  // there is no mean
  const auto sentence = [&](std::size_t count, const char* bias, const char* side) {
    if (count == 0) return std::string();
    return " The mean " + measure + " is too " + bias + ", because it does not include " +
           count_in_words(count) + " of " + reading_count(left_out.of) + ' ' + measure +
           "s, which " + (count == 1 ? "is " : "are ") + side + " the presented levels.";
  };
  return sentence(left_out.below, "high", "below") + sentence(left_out.above, "low", "above");
}

}  // namespace asperity
