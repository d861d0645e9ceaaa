// What a photograph tells about how far its brightness can be trusted as height: little, with
// numbers.

#pragma once

#include <string>
#include <vector>

#include "stimuli/photographs/texture_from_photograph.h"

namespace asperity {

/// Numbers of the brightness b less its own Gaussian low-pass, before any evening out (which makes
/// everything skew).
struct PhotographEvidence {
  /// Third standardised moment. Below 0: narrow and dark on broad and bright; above: the reverse.
  double skewness = 0.0;
  /// (λ₁ − λ₂)/(λ₁ + λ₂) of the mean structure tensor: 0 where the picture changes alike in all
  /// directions, 1 where it changes along one alone. A rough surface that is alike in all
  /// directions gives 0.5 in oblique light.
  double anisotropy = 0.0;
  /// The direction along which the picture changes most, in (−π/2, π/2], from +x towards +y.
  double direction_rad = 0.0;
};

/// `recipe` tells the width and the wavelength of the low-pass. Errors: as texture_from_photograph.
PhotographEvidence examine_photograph(const GreyImage& photograph, const TextureRecipe& recipe,
                                      const std::string& name);

/// What a photograph may show.
enum class PhotographResemblance {
  directed,       ///< light from one side, or a surface with a grain
  dark_grooves,   ///< brightness may follow height, bright = high
  bright_spots,   ///< brightness may follow height, with either sign
  nothing_clear,  ///< the picture does not say
};

/// All that apply, in the order of their declaration; `nothing_clear` alone.
std::vector<PhotographResemblance> resemblances(const PhotographEvidence& evidence);

/// Some sentences for the person who took the picture: which case it resembles, the numbers, how to
/// choose the sign, and what no single photograph can tell.
std::string advice(const PhotographEvidence& evidence);

}  // namespace asperity
