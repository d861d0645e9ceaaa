// Declares what a protocol specifies about the analysis before there are data.

#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
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

/// Excludes participants by their errors in catch trials, all types and blocks together: those with more errors than
/// stated, or with a greater proportion of errors. One of them is stated.
struct CatchExclusion {
  std::optional<int> more_errors_than{};
  std::optional<double> error_rate_above{};

  bool operator==(const CatchExclusion&) const = default;
};

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

/// Of a magnitude estimation with a standard: the surface of this level of the analysed factor precedes each
/// estimated one, and a number is assigned to it.
struct EstimationModulus {
  std::string standard{};  ///< a level of EstimationDeclaration::factor(), as text
  double value = 0.0;      ///< the number of the standard; above 0
  bool operator==(const EstimationModulus&) const = default;
};

/// What is removed from the logarithms L of a participant's estimates before means and curves are computed.
enum class EstimateNormalisation {
  geometric_mean,  ///< L − mean over the participant's cells + grand mean
  standard,        ///< L − (mean at the standard over conditions) + log₁₀(modulus)
  none,            ///< nothing: the modulus is that of the protocol
};

/// The predictor of a magnitude that is the number of the level itself, or a number that the protocol declares for it.
inline constexpr const char* kLevelPredictor = "level";
inline constexpr const char* kValuePredictor = "values";

/// The key `estimation` of a magnitude: the factors of the analysis of its estimates.
struct EstimationDeclaration {
  std::string spacing{};    ///< the factor whose levels are spacings; empty: `items` is stated
  std::string condition{};  ///< the factor that is constant within a block; empty: none
  /// Levels of `condition`, as text, in the protocol's order, which is that of tables and figures.
  std::vector<std::string> conditions{};
  /// Metres by level of `spacing`, as text. A texture without a spacing is not included.
  std::map<std::string, double, std::less<>> spacing_m{};

  std::string items{};  ///< the factor whose levels are the estimated stimuli, whatever they are
  std::vector<std::string> item_levels{};  ///< of `items`, as text, in the protocol's order
  /// Of `items`: kLevelPredictor, kValuePredictor, or a measured property of the items (property_of_items);
  /// empty: none, so that there are means by item and no exponent.
  std::string predictor{};
  std::string predictor_unit{};  ///< of levels and values: that of the factor, or the declared one
  /// With kLevelPredictor and kValuePredictor: the predictor by level of `items`, as text.
  std::map<std::string, double, std::less<>> predictor_values{};

  std::optional<EstimationModulus> modulus{};  ///< absent: free modulus
  std::optional<EstimateNormalisation> stated_normalisation{};

  /// The factor whose levels are compared.
  const std::string& factor() const noexcept { return spacing.empty() ? items : spacing; }
  /// As stated; otherwise the geometric mean with free modulus, and none with a standard.
  EstimateNormalisation normalisation() const noexcept {
    return stated_normalisation.value_or(modulus ? EstimateNormalisation::none
                                                 : EstimateNormalisation::geometric_mean);
  }
};

}  // namespace asperity
