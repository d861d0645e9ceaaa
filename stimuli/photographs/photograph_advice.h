// Declares the evidence in a photograph on whether its brightness follows height, and the advice from it.

#pragma once

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

/// Advice for the photographer, in sentences: which case the photograph resembles, the statistics, how to choose the
/// sign, and what a single photograph cannot determine.
std::string advice(const PhotographEvidence& evidence);

}  // namespace asperity
