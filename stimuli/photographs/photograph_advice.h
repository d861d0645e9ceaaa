// Declares the evidence in a photograph on whether its brightness follows height, and the advice from it.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/words/phrase.h"
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

/// The light in which a photograph was taken. Only the user knows it: photographs of measured surfaces under a single lamp had an
/// anisotropy of 0.14 to 0.24, and a surface with a grain has a greater one in any light.
enum class PhotographLight {
  even,      ///< from all sides
  one_lamp,  ///< from one side
};

/// The spectral tilt that is recommended for even light. It was chosen on the development reliefs of docs/photographs.md and is
/// not changed by later evaluations.
inline constexpr double kRecommendedTilt = 0.5;

/// The method that is recommended for a light.
struct MethodRecommendation {
  const char* method = "";     ///< an id of texture_methods()
  double spectral_tilt = 0.0;  ///< for this method
};
MethodRecommendation recommended_method(PhotographLight light) noexcept;

/// The direction of the greatest change of brightness in whole degrees, in (−90, 90]. Under one lamp, its azimuth is near this
/// direction or the opposite one, unless the surface has a grain.
double direction_deg(const PhotographEvidence& evidence) noexcept;
/// The opposite direction, in (−180, 180].
double opposite_deg(double direction_deg) noexcept;

/// The question about the light and the recommendation for each answer, as English sentences with the options of the command
/// line. What `recipe` has already is confirmed.
std::string recommendation_text(const PhotographEvidence& evidence, const TextureRecipe& recipe);

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

/// Advice for the photographer, in sentences: which case the photograph resembles, the statistics, which sign is correct in
/// which case, and what a single photograph cannot determine.
Phrase advice(const PhotographEvidence& evidence);

}  // namespace asperity
