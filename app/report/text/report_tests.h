// The tests among the findings of an analysis, each put together from the findings that belong to it.

#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/finding.h"

namespace asperity {

/// One p with the statistic, its degrees of freedom, the estimate and the adjusted p that go with it,
/// where there are such findings. They are found by name and place, whatever the analysis: beside
/// "chisq.p" of a key stand "chisq" and "chisq.df" of the same key; beside "pair.p" "pair.t" and
/// "pair.diff"; beside a bare "p" the last estimate with an interval before it; Holm's is the name
/// with ".holm" after it.
struct ReportedTest {
  const Finding* p = nullptr;
  const Finding* statistic = nullptr;
  std::vector<const Finding*> degrees{};  ///< one, or two of an F
  /// The same estimate, perhaps with more than one interval.
  std::vector<const Finding*> estimates{};
  const Finding* holm = nullptr;
  /// About everything, where others of the same kind are about parts, and not about a part.
  bool is_of_whole = true;
};

/// In the order of the findings, which have to outlive them. A p without a value is none.
std::vector<ReportedTest> tests_among(std::span<const Finding> findings);

/// "For height_map (all repetitions), proportion chosen was 0.78 (95 % CI [0.66, 0.87]); exact
/// two-sided binomial test …: p < .001, Holm-corrected p = .003 (n = 20)."
std::string sentence_of(const ReportedTest& test);

/// "χ²(2) = 9.10"; empty where there is no statistic.
std::string statistic_of(const ReportedTest& test);

/// "column=all item=height_map" → "height_map (all repetitions)"; "exp1|image" → "exp1, image".
std::string words_of_key(const std::string& key);

/// "share_chosen" → "proportion chosen"
std::string words_of_quantity(const std::string& quantity);

}  // namespace asperity
