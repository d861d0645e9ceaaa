// Declares what a protocol specifies about the analysis before there are data.

#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "protocols/kind_keys/discrimination.h"
#include "protocols/kind_keys/rating.h"

namespace asperity {

/// The names of the tests that compare the groups to which the protocol assigns participants, and the form of their profiles.
inline constexpr const char* kGroupsTest = "groups";
inline constexpr const char* kGroupProfilesTest = "group_profiles";
inline bool compares_groups(std::string_view test) noexcept {
  return test == kGroupsTest || test == kGroupProfilesTest;
}

/// The key `analysis`. The p values of the family are Holm-corrected together. This keeps the probability of any false
/// positive among them at the set level only if the family was chosen before the data.
struct AnalysisDeclaration {
  std::optional<std::string>
      target{};  ///< of a selection: the item tested for superiority over others
  std::vector<std::string> family{};  ///< names of tests; empty: not declared
  /// Of a matching or a recognition: differences of proportions correct from −margin to +margin count as equivalence.
  std::optional<double> equivalence_margin{};
  std::map<std::string, ConstructDeclaration, std::less<>> constructs{};  ///< of a rating, by name
  /// Of a discrimination with catch trials: the results are reported with and without these participants.
  std::optional<CatchExclusion> exclude{};
  bool operator==(const AnalysisDeclaration&) const = default;
};

}  // namespace asperity
