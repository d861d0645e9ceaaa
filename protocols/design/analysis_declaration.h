// Declares what a protocol specifies about the analysis before there are data.

#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// Scales of ratings that are to measure the same attribute of the items: the test items of Cronbach's alpha.
struct ConstructDeclaration {
  std::vector<std::string> scales{};         ///< names of questions with a scale; at least two
  std::vector<std::string> reverse_keyed{};  ///< those of them on which the attribute decreases

  bool is_reversed(const std::string& scale) const {
    return std::find(reverse_keyed.begin(), reverse_keyed.end(), scale) != reverse_keyed.end();
  }
  bool operator==(const ConstructDeclaration&) const = default;
};

/// The key `analysis`. The p values of the family are Holm-corrected together. This keeps the probability of any false
/// positive among them at the set level only if the family was chosen before the data.
struct AnalysisDeclaration {
  std::optional<std::string>
      target{};  ///< of a selection: the item tested for superiority over others
  std::vector<std::string> family{};  ///< names of tests; empty: not declared
  /// Of a matching or a recognition: differences of proportions correct from −margin to +margin count as equivalence.
  std::optional<double> equivalence_margin{};
  std::map<std::string, ConstructDeclaration, std::less<>> constructs{};  ///< of a rating, by name
  bool operator==(const AnalysisDeclaration&) const = default;
};

/// The key `estimation` of a magnitude: the factors of the analysis of its estimates.
struct EstimationDeclaration {
  std::string spacing{};    ///< the factor whose levels are spacings
  std::string condition{};  ///< the factor that is constant within a block; empty: none
  /// Levels of `condition`, as text, in the protocol's order, which is that of tables and figures.
  std::vector<std::string> conditions{};
  /// Metres by level of `spacing`, as text. A texture without a spacing is not included.
  std::map<std::string, double, std::less<>> spacing_m{};
};

}  // namespace asperity
