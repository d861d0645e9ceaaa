// Combines the findings of an analysis into tests.

#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/numbers/finding.h"

namespace asperity {

/// One p with its statistic, degrees of freedom, estimate and adjusted p, where there are such
/// findings. They are found by name and place, for every analysis: "chisq.p" of a key belongs to
/// "chisq" and "chisq.df" of the same key; "pair.p" to "pair.t" and "pair.diff"; a bare "p" to the
/// last estimate with an interval before it; Holm's adjusted p has the name followed by ".holm".
struct ReportedTest {
  const Finding* p = nullptr;
  const Finding* statistic = nullptr;
  std::vector<const Finding*> degrees{};  ///< one, or two of an F
  /// The same estimate, which may have several intervals.
  std::vector<const Finding*> estimates{};
  const Finding* holm = nullptr;
  /// A test of all data, where others of the same kind test parts.
  bool is_of_whole = true;
};

/// In the order of the findings, which have to outlive them. A p without a value is not a test.
std::vector<ReportedTest> tests_among(std::span<const Finding> findings);

/// "For height_map (all repetitions), proportion chosen was 0.78 (95 % CI [0.66, 0.87]); exact
/// two-sided binomial test …: p < .001, Holm-corrected p = .003 (n = 20)."
std::string sentence_of(const ReportedTest& test);

/// "χ²(2) = 9.10"; empty where there is no statistic.
std::string statistic_of(const ReportedTest& test);

/// "column=all item=height_map" → "height_map (all repetitions)"; of "exp1" and "image" "exp1, image".
std::string words_of_key(const FindingKey& key);

/// "share_chosen" → "proportion chosen"
std::string words_of_quantity(const std::string& quantity);

}  // namespace asperity
