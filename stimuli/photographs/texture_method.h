// Declares the methods by which the brightness of a photograph becomes a relief.

#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "stimuli/photographs/texture_recipe.h"
#include "stimuli/pictures/grey_image.h"

namespace asperity {

/// A method of computing f, the relief before its long wavelengths are removed (texture_from_photograph.h).
struct TextureMethod {
  std::string id{};      ///< `[a-z][a-z0-9_]*`, used on the command line and in sidecars
  Phrase summary{};      ///< without a full stop
  std::string source{};  ///< the publication; empty for a method without one
  /// Uses the direction of the light, which also determines the sign of the heights.
  bool uses_light = false;
  /// f of a grey picture. The result does not depend on the number of threads.
  std::function<GreyImage(const GreyImage& grey, const TextureRecipe& recipe, int threads)>
      relief{};
};

/// All methods; the first is the published one.
const std::vector<TextureMethod>& texture_methods();

/// The method with this id. Errors: std::invalid_argument that lists the ids.
const TextureMethod& texture_method(std::string_view id);

/// Errors: std::invalid_argument for an unknown method, and for a method that uses the light: a direction that it does not
/// accept, sign −1, and a histogram transformation.
void check_method(const TextureRecipe& recipe);

/// r, the brightness relative to level ground, which is estimated as the low-pass of the brightness b:
/// (b + ε)/(ℱ⁻¹[exp(−ν² λ_h²) ℱ b] + ε).
GreyImage relative_light(const GreyImage& grey, const TextureRecipe& recipe, int threads);

}  // namespace asperity
