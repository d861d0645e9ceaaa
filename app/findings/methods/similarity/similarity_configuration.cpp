// Reads level, stress and dimensions from the findings; metric scaling replaces a degenerate configuration.

#include "app/findings/methods/similarity/similarity_configuration.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "analysis/dissimilarity/rated_dissimilarities.h"
#include "analysis/numbers/number_text.h"
#include "app/findings/outcome/display_number.h"
#include "app/findings/outcome/estimate_sentences.h"
#include "app/findings/tidy/finding_list.h"
#include "app/words/text_parts.h"

namespace asperity {

namespace {

std::optional<Phrase> remark_on_degenerate_solution(const FoundNumbers& found) {
  if (!is_metric(found)) return std::nullopt;
  const double disparities = found.value("ordinal.disparities").value_or(0.0);
  if (disparities <= static_cast<double>(kDisparitiesOfDegenerate)) {
    return phrase(
               "Analysis",
               "The non-metric configuration is degenerate (different disparities: %1): it shows "
               "which items form clusters, and neither their distances nor the number of "
               "dimensions. The configuration of metric scaling is reported instead.")
        .with(fixed(disparities, 0));
  }
  std::vector<std::string> items{};
  for (const Finding* const one : found.all("ordinal.collapsed")) items.push_back(one->key.last());
  std::vector<double> means{};
  for (const std::string& one : items) {
    for (const std::string& other : items) {
      if (const auto mean = found.value("dissimilarity", {one, other})) means.push_back(*mean);
    }
  }
  const auto [least, greatest] = std::minmax_element(means.begin(), means.end());
  return phrase("Analysis",
                "The non-metric configuration is degenerate: %1 items lie on one point (%2), and "
                "their mean dissimilarities, on which its stress does not depend, are %3 to %4. "
                "The configuration of metric scaling is reported instead.")
      .with(std::to_string(items.size()), listed(items), fixed(*least, 1), fixed(*greatest, 1));
}

/// The configuration has at least two dimensions.
bool has_one_chosen_dimension(const FoundNumbers& found) {
  return found.value("cv.chosen").value_or(2.0) < 2.0;
}

}  // namespace

std::size_t dimensions_in(const FoundNumbers& found) {
  return static_cast<std::size_t>(found.value("dimensions").value_or(0.0));
}

bool is_metric(const FoundNumbers& found) {
  const Finding* const level = found.find("configuration.level");
  return level != nullptr && level->word == "ratio";
}

QuantityName stress_quantity(const FoundNumbers& found) {
  return is_metric(found) ? QuantityName("stress.ratio") : "stress.ordinal";
}

std::optional<double> stress_of_configuration(const FoundNumbers& found) {
  return found.value(stress_quantity(found), std::to_string(dimensions_in(found)));
}

std::string stress_text(double stress) {
  constexpr int kDecimals = 3;
  return fixed(stress, kDecimals);
}

std::vector<Phrase> remarks_on_configuration(const FoundNumbers& found) {
  std::vector<Phrase> remarks{};
  if (auto remark = remark_on_degenerate_solution(found)) remarks.push_back(*std::move(remark));
  const Finding* const too_many = found.find("dimensions.too.many");
  if (too_many != nullptr && too_many->word == "TRUE") {
    const std::size_t positions = found.all("position").size();
    const std::size_t dimensions = std::max<std::size_t>(dimensions_in(found), 1);
    remarks.push_back(
        phrase("Analysis",
               "The configuration is poorly determined: %1 dimensions require at least %2 items, "
               "and the number of items is %3.")
            .with(std::to_string(dimensions),
                  fixed(found.value("dimensions.items").value_or(0.0), 0),
                  std::to_string(positions / dimensions)));
  }
  if (has_one_chosen_dimension(found)) {
    remarks.push_back(
        phrase("Analysis",
               "Cross-validation chooses one dimension; the configuration is shown in two, and the "
               "second may be due to chance."));
  }
  return remarks;
}

Phrase qualification_of_stress(const FoundNumbers& found) {
  if (is_metric(found)) {
    return phrase("Analysis",
                  "Metric scaling, because the non-metric configuration is degenerate.");
  }
  if (!has_one_chosen_dimension(found)) return {};
  return phrase("Analysis", "Cross-validation chose one dimension; at least two are shown.");
}

EstimateSentence configuration_sentence(const AnalysisOutcome& outcome) {
  std::vector<Finding> own{};
  std::copy_if(outcome.findings.begin(), outcome.findings.end(), std::back_inserter(own),
               [](const Finding& one) { return one.analysis == kConfiguration; });
  const FoundNumbers found(own);
  const std::size_t dimensions = dimensions_in(found);
  const auto stress = stress_of_configuration(found);
  const auto metric =
      is_metric(found) ? std::nullopt : found.value("stress.ratio", std::to_string(dimensions));
  if (dimensions == 0 || !stress) return {};
  std::string text = "The configuration in " + std::to_string(dimensions) +
                     " dimensions had a stress-1 of " + stress_text(*stress);
  if (metric) text += " (metric scaling: " + stress_text(*metric) + ')';
  text += '.';
  const Phrase qualification = qualification_of_stress(found);
  if (!qualification.empty()) text += ' ' + qualification.english();
  const auto together = found.value("protest.r2");
  const auto p = found.value("protest.p");
  if (together && p) {
    text +=
        " All measured properties together, as a configuration of their standardised values: "
        "Procrustes r² = " +
        display_bounded(*together) + ", permutation test (PROTEST) " + display_p(*p) +
        ", uncorrected.";
  }
  return {.text = text};
}

}  // namespace asperity
