// What a protocol states for a magnitude estimation alone.

#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

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

/// How a virtual participant estimates; see virtual_observer.h.
struct MagnitudeObserver {
  double exponent = 1.0;  ///< of the power law of its numbers
};

}  // namespace asperity
