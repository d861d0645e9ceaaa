// What a protocol declares, before there are data, about their analysis.

#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// The key `analysis`. Its p values are adjusted together after Holm: only then does the chance of
/// any false alarm among them stay where it was set, and only if the family was chosen before the
/// data.
struct AnalysisDeclaration {
  std::optional<std::string>
      target{};                       ///< of a selection: the item whose superiority is in question
  std::vector<std::string> family{};  ///< names of tests; empty: not declared
  /// Of a matching or a recognition: differences of proportions correct from −margin to +margin count as
  /// none.
  std::optional<double> equivalence_margin{};
  bool operator==(const AnalysisDeclaration&) const = default;
};

/// The key `estimation` of a magnitude: what estimates are analysed by.
struct EstimationDeclaration {
  std::string spacing{};    ///< the factor whose levels are spacings
  std::string condition{};  ///< the factor that is held within a block; empty: there is none
  /// Levels of the second, as text, in the order in which the protocol lists them: tables and figures
  /// have them in this order.
  std::vector<std::string> conditions{};
  /// Metres by level of the first, as text. A texture without a spacing is not in it.
  std::map<std::string, double, std::less<>> spacing_m{};
};

}  // namespace asperity
