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

  LeftOutThresholds& operator+=(const LeftOutThresholds& own) {
    of += own.of;
    below += own.below;
    above += own.above;
    for (const auto& [reason, count] : own.others) others[reason] += count;
    return *this;
  }
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

/// "2 below the presented levels; a mean without such thresholds is too high": empty where none is on a side.
Phrase bias_text(const LeftOutThresholds& left_out) {
  const std::string below = std::to_string(left_out.below);
  const std::string above = std::to_string(left_out.above);
  if (left_out.below > 0 && left_out.above > 0) {
    return phrase("Analysis",
                  "%1 below and %2 above the presented levels; the direction of the bias of a mean "
                  "without such thresholds is unknown")
        .with(below, above);
  }
  if (left_out.below > 0) {
    return phrase("Analysis",
                  "%1 below the presented levels; a mean without such thresholds is too high")
        .with(below);
  }
  if (left_out.above > 0) {
    return phrase("Analysis",
                  "%1 above the presented levels; a mean without such thresholds is too low")
        .with(above);
  }
  return {};
}

}  // namespace

Phrase with_left_out_thresholds(Phrase answer, const DiscriminationResults& results) {
  const LeftOutThresholds left_out =
      left_out_thresholds(results.fit.thresholds, results.quantity_of_threshold());
  const std::string all = std::to_string(left_out.of);
  const bool has_conditions = results.conditions.size() > 1;
  if (const Phrase bias = bias_text(left_out); !bias.empty()) {
    answer =
        (has_conditions
             ? phrase("Analysis", "%1 Left out of %2 thresholds (participants by conditions): %3.")
             : phrase("Analysis", "%1 Left out of %2 thresholds: %3."))
            .with(answer, all, bias);
  }
  if (const std::size_t others = left_out.other(); others > 0) {
    answer =
        (has_conditions
             ? phrase("Analysis",
                      "%1 Not estimated: %2 of %3 thresholds (participants by conditions; %4).")
             : phrase("Analysis", "%1 Not estimated: %2 of %3 participants (%4)."))
            .with(answer, std::to_string(others), all, left_out.reasons());
  }
  return answer;
}

Phrase with_left_out_means(Phrase note, const std::vector<DiscriminationResults>& all) {
  for (const char* const quantity : {"pse", "jnd", "jnd.dprime1"}) {
    LeftOutThresholds left_out{};
    for (const DiscriminationResults& results : all) {
      left_out += left_out_thresholds(results.fit.thresholds, quantity);
    }
    const std::size_t missing = left_out.below + left_out.above + left_out.other();
    if (missing == 0 || missing == left_out.of) continue;
    std::string code(quantity);
    std::replace(code.begin(), code.end(), '.', '_');
    const Phrase measure = words_of_cell("measure", code);
    const std::string thresholds = std::to_string(left_out.of);
    if (const Phrase bias = bias_text(left_out); !bias.empty()) {
      note = phrase("Analysis", "%1 %2: left out of %3 thresholds: %4.")
                 .with(note, measure, thresholds, bias);
    }
    if (left_out.other() > 0) {
      note = phrase("Analysis", "%1 %2: %3 of %4 thresholds could not be estimated (%5).")
                 .with(note, measure, std::to_string(left_out.other()), thresholds,
                       left_out.reasons());
    }
  }
  return note;
}

std::string bias_sentence(const std::vector<Finding>& findings, const std::string& quantity,
                          const std::string& measure) {
  const LeftOutThresholds left_out = left_out_thresholds(findings, quantity);
  if (left_out.below + left_out.above + left_out.other() == left_out.of)
    return {};  // there is no mean
  const Phrase bias = bias_text(left_out);
  if (bias.empty()) return {};
  return " Of the " + reading_count(left_out.of) + ' ' + measure + "s, the mean does not include " +
         bias.english() + '.';
}

}  // namespace asperity
