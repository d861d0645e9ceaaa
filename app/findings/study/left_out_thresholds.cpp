#include "app/findings/study/left_out_thresholds.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>

#include "app/findings/reading_number.h"
#include "app/findings/study/cell_words.h"
#include "app/findings/study/missing_threshold.h"

namespace asperity {

namespace {

/// Estimates of a threshold that means leave out, by the side of the presented levels on which they lie.
struct LeftOutThresholds {
  std::size_t of = 0;
  std::size_t below = 0;
  std::size_t above = 0;
  std::map<std::string, std::size_t> others{};  ///< by the code of the reason

  std::size_t other() const {
    std::size_t sum = 0;
    for (const auto& [reason, count] : others) sum += count;
    return sum;
  }
  Phrase reasons() const {
    Phrase all{};
    for (const auto& [reason, count] : others) {
      const Phrase words = words_of_cell("status", reason);
      const Phrase one = others.size() == 1
                             ? words
                             : phrase("Analysis", "%1: %2").with(std::to_string(count), words);
      all = all.empty() ? one : phrase("Analysis", "%1; %2").with(all, one);
    }
    return all;
  }
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
    if (side == SideOfThreshold::unknown) ++left_out.others[finding.word];
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
  if (const std::size_t others = left_out.other(); others > 0) {
    answer =
        (has_conditions
             ? phrase("Analysis",
                      "%1 Not estimated: %2 of %3 thresholds (participants by conditions; %4).")
             : phrase("Analysis", "%1 Not estimated: %2 of %3 participants (%4)."))
            .with(answer, std::to_string(others), std::to_string(left_out.of), left_out.reasons());
  }
  return answer;
}

Phrase with_left_out_means(Phrase note, const std::vector<DiscriminationResults>& all) {
  for (const char* const quantity : {"pse", "jnd", "jnd.dprime1"}) {
    LeftOutThresholds left_out{};
    for (const DiscriminationResults& results : all) {
      const LeftOutThresholds own = left_out_thresholds(results.fit.thresholds, quantity);
      left_out.of += own.of;
      left_out.below += own.below;
      left_out.above += own.above;
      for (const auto& [reason, count] : own.others) left_out.others[reason] += count;
    }
    const std::size_t missing = left_out.below + left_out.above + left_out.other();
    if (missing == 0 || missing == left_out.of) continue;
    std::string code(quantity);
    std::replace(code.begin(), code.end(), '.', '_');
    const Phrase measure = words_of_cell("measure", code);
    const auto add = [&](const Phrase& sentence, std::size_t count) {
      if (count == 0) return;
      note = sentence.with(note, measure, std::to_string(count), std::to_string(left_out.of));
    };
    if (left_out.below > 0 && left_out.above > 0) {
      note = phrase("Analysis",
                    "%1 %2: the means do not include %3 thresholds below and %4 above the "
                    "presented levels (of %5), so that the direction of their bias is unknown.")
                 .with(note, measure, std::to_string(left_out.below),
                       std::to_string(left_out.above), std::to_string(left_out.of));
    } else {
      add(phrase("Analysis",
                 "%1 %2: the means do not include %3 of %4 thresholds, which are below the "
                 "presented levels; means that lack one are too high."),
          left_out.below);
      add(phrase("Analysis",
                 "%1 %2: the means do not include %3 of %4 thresholds, which are above the "
                 "presented levels; means that lack one are too low."),
          left_out.above);
    }
    if (left_out.other() > 0) {
      note = phrase("Analysis", "%1 %2: %3 of %4 thresholds could not be estimated (%5).")
                 .with(note, measure, std::to_string(left_out.other()), std::to_string(left_out.of),
                       left_out.reasons());
    }
  }
  return note;
}

std::string bias_sentences(const std::vector<Finding>& findings, const std::string& quantity,
                           const std::string& measure) {
  const LeftOutThresholds left_out = left_out_thresholds(findings, quantity);
  if (left_out.below + left_out.above + left_out.other() == left_out.of)
    return {};  // there is no mean
  const auto sentence = [&](std::size_t count, const char* bias, const char* side) {
    if (count == 0) return std::string();
    return " The mean " + measure + " is too " + bias + ", because it does not include " +
           count_in_words(count) + " of " + reading_count(left_out.of) + ' ' + measure +
           "s, which " + (count == 1 ? "is " : "are ") + side + " the presented levels.";
  };
  return sentence(left_out.below, "high", "below") + sentence(left_out.above, "low", "above");
}

}  // namespace asperity
