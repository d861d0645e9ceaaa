// Declares the evidence in a photograph on whether its brightness follows height, and the advice from it.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "stimuli/photographs/texture_from_photograph.h"

namespace asperity {

/// Statistics of the brightness b minus its Gaussian low-pass, without homomorphic filtering (which makes every picture
/// skewed).
struct PhotographEvidence {
  /// Third standardised moment. Negative: narrow dark parts on broad bright ground; positive: the reverse.
  double skewness = 0.0;
  /// (λ₁ − λ₂)/(λ₁ + λ₂) of the mean structure tensor: 0 for a picture that changes equally in all directions, 1 for
  /// one that changes along one direction only. An isotropic rough surface in oblique light gives 0.5.
  double anisotropy = 0.0;
  /// The direction of the greatest change of brightness, in (−π/2, π/2], from +x towards +y.
  double direction_rad = 0.0;
};

/// `recipe` gives the width and the wavelength of the low-pass. Errors: those of texture_from_photograph.
PhotographEvidence examine_photograph(const GreyImage& photograph, const TextureRecipe& recipe,
                                      const std::string& name);

/// A possible interpretation of a photograph.
enum class PhotographResemblance {
  directed,       ///< light from one side, or a surface with a grain
  dark_grooves,   ///< brightness may follow height, bright = high
  bright_spots,   ///< brightness may follow height, with either sign
  nothing_clear,  ///< the picture does not determine it
};

/// All interpretations that apply, in the order of their declaration; `nothing_clear` only alone.
std::vector<PhotographResemblance> resemblances(const PhotographEvidence& evidence);

/// The methods that are recommended (texture_method.h), and the spectral tilt for the first one. The tilt was chosen on the
/// development reliefs of docs/photographs.md and is not changed by later evaluations.
inline constexpr const char* kBrightnessMethod = "brightness";
inline constexpr const char* kShadingMethod = "pentland";
inline constexpr double kRecommendedTilt = 0.5;

/// The reason of a recommendation.
enum class RecommendationReason {
  no_direction,   ///< the brightness varies equally in all directions, as in even light
  one_direction,  ///< the brightness varies mostly along one direction, as in light from one side
};

/// The method that a photograph suggests, with the numbers from which it follows.
struct MethodRecommendation {
  RecommendationReason reason = RecommendationReason::no_direction;
  std::string method{};        ///< an id of texture_methods()
  double spectral_tilt = 0.0;  ///< for this method
  double anisotropy = 0.0;
  /// For one_direction: the azimuth of the light, in (−90, 90], or the opposite direction.
  double direction_deg = 0.0;
};

/// Recommends pentland for a picture with one direction, and otherwise the brightness with a spectral tilt. A grain in even
/// light has one direction as well: the user decides, because the picture does not differ.
MethodRecommendation recommended_method(const PhotographEvidence& evidence);

/// The recommendation as English sentences with the options of the command line.
std::string recommendation_text(const MethodRecommendation& recommendation);

/// A sign of the heights that the skewness of the photograph contradicts.
enum class SignContradiction {
  dark_grooves_raised,  ///< narrow dark parts become ridges
  bright_spots_raised,  ///< narrow bright parts become ridges; they may be low
};

/// The contradiction, if any; none for a method that uses the light, which determines the sign.
std::optional<SignContradiction> contradiction_of_sign(const PhotographEvidence& evidence,
                                                       const TextureRecipe& recipe);

/// The contradiction as English sentences with the skewness and the option of the command line.
std::string contradiction_text(SignContradiction contradiction, const PhotographEvidence& evidence);

/// Advice for the photographer, in sentences: which case the photograph resembles, the statistics, how to choose the
/// sign, and what a single photograph cannot determine.
std::string advice(const PhotographEvidence& evidence);

}  // namespace asperity
