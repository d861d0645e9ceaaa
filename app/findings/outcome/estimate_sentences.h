// Reports the estimates of a study in sentences, which a paper prints before its tests.

#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/tidy/quantity_name.h"

namespace asperity {

/// The findings of an analysis that are numbers of this quantity, in their order. The outcome must outlive them.
std::vector<const Finding*> numbers_among(const AnalysisOutcome& outcome, std::string_view analysis,
                                          QuantityName quantity);
/// The same without those of pairs, whose keys are two names.
std::vector<const Finding*> estimates_among(const AnalysisOutcome& outcome,
                                            std::string_view analysis, QuantityName quantity);

using EstimateText = std::function<std::string(double)>;
/// "83 % (95 % CI [49 %, 96 %]) for height_map and 17 % (…) for sinusoid, N = 6"; the estimate of `only_key` without its key.
std::string all_estimates(const std::vector<const Finding*>& estimates, const std::string& only_key,
                          const EstimateText& shown);

/// In English; empty for kinds whose tests state their estimates (matching, recognition).
struct EstimateSentence {
  std::string text{};
  bool has_mean_interval = false;  ///< the 95 % CI is that of a mean proportion
};

/// For a selection: "Mean proportions of choices were 83 % (95 % CI [49 %, 96 %]) for height_map
/// and 17 % (…) for sinusoid, N = 6; the chance level was 50 %.", where every trial presented every
/// item.
EstimateSentence choices_sentence(const AnalysisOutcome& outcome);
/// For a paired comparison: the log-worths of the scale, the mean proportions of comparisons in which an item was chosen, and the
/// mean coefficient of consistence.
EstimateSentence pairs_sentence(const AnalysisOutcome& outcome);

/// For a similarity: the number of dimensions and the stress of the configuration, what qualifies it, and its relation to all
/// measured properties together.
EstimateSentence configuration_sentence(const AnalysisOutcome& outcome);

/// The means of items, which the sentences of confirmatory tests state.
struct MeansOfItems {
  std::string_view analysis{};  ///< of the findings
  QuantityName quantity{};
  std::string scale{};  ///< with which their keys begin; empty: an item is the key
  std::vector<std::string> items{};
  std::vector<std::string> tests{};  ///< of all items, about the scale
  std::vector<std::string> tests_of_pairs{};
  /// Whether the mean of an item in a sentence about a pair is that within the pair, whose key is both names, its own first.
  bool within_pairs = false;
  std::string (*shown)(double mean) = nullptr;
};
/// Adds "; means: 4.25 (95 % CI [3.90, 4.60]) for brick and 2.10 (…) for wood" to these sentences.
void state_means_of_items(AnalysisOutcome& outcome, const MeansOfItems& means);

/// The sentence of the outcome's kind.
EstimateSentence estimate_sentence(const AnalysisOutcome& outcome);

}  // namespace asperity
