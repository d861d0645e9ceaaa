#include "app/findings/study/similarity_configuration.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

#include "analysis/number_text.h"
#include "app/findings/reading_number.h"
#include "app/findings/study/estimate_sentences.h"
#include "app/findings/tidy/finding_list.h"
#include "app/words/text_parts.h"

namespace asperity {

namespace {

/// Items on one point of the configuration, and the range of their mean dissimilarities.
struct CoincidingItems {
  /// Those of the largest such point; empty where fewer than three coincide.
  std::vector<std::string> items{};
  double least = 0.0;
  double greatest = 0.0;
};

/// Non-metric scaling can also collapse a part of the items, if their dissimilarities are below those to all others: the
/// stress is then low whatever the sizes of the dissimilarities within that part.
CoincidingItems coinciding_items(const FoundNumbers& found) {
  constexpr double kSame = 0.01;  // of the largest distance
  constexpr std::size_t kFewest = 3;
  double largest = 0.0;
  std::set<std::string> names{};
  for (const Finding* const one : found.all("distance")) {
    largest = std::max(largest, one->value.value_or(0.0));
    for (const std::string& name : parts_of(one->key, '|')) names.insert(name);
  }
  const auto coincide = [&](const std::string& one, const std::string& other) {
    auto distance = found.value("distance", both(one, other));
    if (!distance) distance = found.value("distance", both(other, one));
    return distance && *distance <= kSame * largest;
  };
  CoincidingItems most{};
  for (const std::string& name : names) {
    std::vector<std::string> own{name};
    std::copy_if(names.begin(), names.end(), std::back_inserter(own),
                 [&](const std::string& other) { return other != name && coincide(name, other); });
    if (own.size() >= kFewest && own.size() > most.items.size()) most.items = std::move(own);
  }
  bool is_first = true;
  for (std::size_t i = 0; i < most.items.size(); ++i) {
    for (std::size_t j = i + 1; j < most.items.size(); ++j) {
      auto mean = found.value("dissimilarity", both(most.items[i], most.items[j]));
      if (!mean) mean = found.value("dissimilarity", both(most.items[j], most.items[i]));
      if (!mean) continue;
      most.least = is_first ? *mean : std::min(most.least, *mean);
      most.greatest = is_first ? *mean : std::max(most.greatest, *mean);
      is_first = false;
    }
  }
  return most;
}

std::optional<Phrase> remark_on_degenerate_solution(const FoundNumbers& found) {
  if (is_metric(found)) {
    return phrase(
               "Analysis",
               "The non-metric configuration is degenerate (different disparities: %1): it shows "
               "which items form clusters, and neither their distances nor the number of "
               "dimensions. The configuration of metric scaling is reported instead.")
        .with(fixed(found.value("ordinal.disparities").value_or(0.0), 0));
  }
  const CoincidingItems same = coinciding_items(found);
  if (same.items.empty()) return std::nullopt;
  return phrase("Analysis",
                "The configuration is partly degenerate: %1 items lie on one point (%2), and their "
                "mean dissimilarities are %3 to %4. The stress does not depend on these "
                "dissimilarities. Compare them with those of identical pairs, and use the "
                "dendrogram and the stress of metric scaling.")
      .with(std::to_string(same.items.size()), listed(same.items), fixed(same.least, 1),
            fixed(same.greatest, 1));
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

std::optional<double> stress_of_configuration(const FoundNumbers& found) {
  return found.value(is_metric(found) ? "stress.ratio" : "stress.ordinal",
                     std::to_string(dimensions_in(found)));
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
  if (const std::size_t same = coinciding_items(found).items.size(); same > 0) {
    const std::optional<double> metric =
        found.value("stress.ratio", std::to_string(dimensions_in(found)));
    const Phrase collapsed =
        phrase("Analysis",
               "The configuration is partly degenerate: %1 items lie on one point, so that a "
               "low stress is not evidence of a good fit.")
            .with(std::to_string(same));
    if (!metric) return collapsed;
    return phrase("Analysis", "%1 The stress-1 of metric scaling is %2.")
        .with(collapsed, stress_text(*metric));
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
  if (metric && coinciding_items(found).items.empty()) {  // otherwise the next sentence states it
    text += " (metric scaling: " + stress_text(*metric) + ')';
  }
  text += '.';
  const Phrase qualification = qualification_of_stress(found);
  if (!qualification.empty()) text += ' ' + qualification.english();
  const auto together = found.value("protest.r2");
  const auto p = found.value("protest.p");
  if (together && p) {
    text +=
        " All measured properties together, as a configuration of their standardised values: "
        "Procrustes r² = " +
        reading_bounded(*together) + ", permutation test (PROTEST) " + reading_p(*p) +
        ", uncorrected.";
  }
  return {.text = text};
}

}  // namespace asperity
