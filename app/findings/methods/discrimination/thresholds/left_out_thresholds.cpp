// Counts missing thresholds by side; a mean is a bound only if all of them lie on one side.

#include "app/findings/methods/discrimination/thresholds/left_out_thresholds.h"

#include <algorithm>

#include "app/findings/methods/discrimination/thresholds/missing_threshold.h"
#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/display_number.h"
#include "app/findings/outcome/study_findings.h"
#include "app/words/text_parts.h"

namespace asperity {

namespace {

std::string condition_of_key(const FindingKey& key) { return key.size() > 1 ? key.last() : "all"; }

Phrase reasons_of(const LeftOutThresholds& left_out) {
  Phrase all{};
  for (const auto& [reason, count] : left_out.others) {
    const Phrase words = words_of_status(reason);
    const Phrase one = left_out.others.size() == 1
                           ? words
                           : phrase("Analysis", "%1: %2").with(std::to_string(count), words);
    all = all.empty() ? one : phrase("Analysis", "%1; %2").with(all, one);
  }
  return all;
}

/// "2 below the presented levels, 1 not estimated (slope at a limit)"
Phrase sides_text(const LeftOutThresholds& left_out) {
  Phrase all{};
  const auto add = [&all](const Phrase& one) {
    all = all.empty() ? one : phrase("Analysis", "%1, %2").with(all, one);
  };
  if (left_out.below > 0) {
    add(phrase("Analysis", "%1 below the presented levels").with(std::to_string(left_out.below)));
  }
  if (left_out.above > 0) {
    add(phrase("Analysis", "%1 above the presented levels").with(std::to_string(left_out.above)));
  }
  if (const std::size_t others = left_out.other(); others > 0) {
    add(phrase("Analysis", "%1 not estimated (%2)")
            .with(std::to_string(others), reasons_of(left_out)));
  }
  return all;
}

Phrase meaning_of(const LeftOutThresholds& left_out) {
  switch (left_out.mean()) {
    case MeanOfThresholds::complete:
      return {};
    case MeanOfThresholds::upper_bound:
      return phrase("Analysis", "the mean of the others is an upper bound and has no CI");
    case MeanOfThresholds::lower_bound:
      return phrase("Analysis", "the mean of the others is a lower bound and has no CI");
    case MeanOfThresholds::no_bound:
      break;
  }
  return phrase("Analysis",
                "the mean of the others is neither an upper nor a lower bound and is not reported");
}

}  // namespace

std::string code_of(MeanOfThresholds mean) {
  switch (mean) {
    case MeanOfThresholds::complete:
      return {};
    case MeanOfThresholds::upper_bound:
      return "upper_bound";
    case MeanOfThresholds::lower_bound:
      return "lower_bound";
    case MeanOfThresholds::no_bound:
      break;
  }
  return "no_bound";
}

std::size_t LeftOutThresholds::other() const {
  std::size_t sum = 0;
  for (const auto& [reason, count] : others) sum += count;
  return sum;
}

MeanOfThresholds LeftOutThresholds::mean() const {
  if (missing() == 0) return MeanOfThresholds::complete;
  if (below == missing()) return MeanOfThresholds::upper_bound;
  return above == missing() ? MeanOfThresholds::lower_bound : MeanOfThresholds::no_bound;
}

LeftOutThresholds left_out_thresholds(std::span<const Finding> thresholds, QuantityName quantity,
                                      std::string_view condition) {
  LeftOutThresholds left_out{};
  for (const Finding& finding : thresholds) {
    if (finding.analysis != kThresholds || !is(finding, quantity) ||
        condition_of_key(finding.key) != condition) {
      continue;
    }
    ++left_out.of;
    if (finding.value) continue;
    const SideOfThreshold side = side_of_threshold(finding);
    left_out.below += side == SideOfThreshold::below ? 1 : 0;
    left_out.above += side == SideOfThreshold::above ? 1 : 0;
    if (side == SideOfThreshold::unknown) ++left_out.others[finding.word];
  }
  return left_out;
}

LeftOutThresholds left_out_of_mean(std::span<const Finding> thresholds, const Finding& mean) {
  return left_out_thresholds(
      thresholds,
      composed_quantity(std::string_view(mean.quantity).substr(mean.quantity.find('.') + 1)),
      mean.key.last());
}

Phrase mean_with_bound(const Finding& mean, const LeftOutThresholds& left_out) {
  const Phrase number = quantity_with_interval(mean);
  switch (left_out.mean()) {
    case MeanOfThresholds::upper_bound:
      return phrase("Analysis", "at most %1").with(number);
    case MeanOfThresholds::lower_bound:
      return phrase("Analysis", "at least %1").with(number);
    case MeanOfThresholds::complete:
    case MeanOfThresholds::no_bound:
      break;
  }
  return number;
}

Phrase with_left_out_thresholds(Phrase answer, const DiscriminationResults& results,
                                QuantityName quantity) {
  for (const std::string& condition : results.conditions) {
    const LeftOutThresholds left_out =
        left_out_thresholds(results.fit.thresholds, quantity, condition);
    if (left_out.missing() == 0) continue;
    const Phrase sides = sides_text(left_out);
    const Phrase what = left_out.missing() == left_out.of
                            ? sides
                            : phrase("Analysis", "%1; %2").with(sides, meaning_of(left_out));
    const std::string of = std::to_string(left_out.of);
    answer = results.conditions.size() > 1
                 ? phrase("Analysis", "%1 Left out of %2 thresholds in the condition %3: %4.")
                       .with(answer, of, words_of_condition(condition), what)
                 : phrase("Analysis", "%1 Left out of %2 thresholds: %3.").with(answer, of, what);
  }
  return answer;
}

std::string bound_sentences(const std::vector<Finding>& findings, QuantityName quantity,
                            const std::string& measure) {
  std::vector<std::string> conditions{};
  for (const Finding& finding : findings) {
    if (finding.analysis != kThresholds || !is(finding, quantity)) continue;
    const std::string condition = condition_of_key(finding.key);
    if (std::find(conditions.begin(), conditions.end(), condition) == conditions.end()) {
      conditions.push_back(condition);
    }
  }
  std::string text{};
  for (const std::string& condition : conditions) {
    const LeftOutThresholds left_out = left_out_thresholds(findings, quantity, condition);
    if (left_out.missing() == 0 || left_out.missing() == left_out.of) continue;
    text += " Of the " + display_count(left_out.of) + ' ' + measure + 's' +
            (condition == "all" ? "" : " in the condition " + words_of_condition(condition)) +
            ", the mean does not include " + sides_text(left_out).english() + "; " +
            meaning_of(left_out).english() + '.';
  }
  return text;
}

}  // namespace asperity
