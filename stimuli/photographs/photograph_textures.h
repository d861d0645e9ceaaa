// Declares the texture of one photograph for interactive changes of its recipe.

#pragma once

#include <memory>
#include <optional>
#include <string>

#include "stimuli/photographs/texture_steps.h"

namespace asperity {

/// Computes the result of `texture_from_photograph`, bit for bit, for a sequence of recipes, and caches the
/// intermediate results.
///
/// A change of the recipe costs only the steps from the first one it affects: amplitude and sign one multiplication,
/// the longest wavelength one filter, γ one and a half; method, light, width, lighting (λ_h) and histogram all steps. Steps that a new
/// recipe does not affect return the same objects as before.
///
/// Errors: those of texture_from_photograph; the next call starts from the valid results.
///
/// Threads: `texture` may be called by one thread at a time and uses `threads` threads; the result does not depend on
/// their number.
class PhotographTextures final {
 public:
  struct Steps {
    std::shared_ptr<const HeightField> field{};
    std::shared_ptr<const GreyImage> grey{};      ///< as in PhotographTexture
    std::shared_ptr<const GreyImage> evened{};    ///< f
    std::shared_ptr<const GreyImage> low_pass{};  ///< g
  };

  /// `name` is the photograph's name in error messages.
  PhotographTextures(GreyImage photograph, std::string name);
  PhotographTextures(GreyImage photograph, std::string name, int threads);

  const GreyImage& photograph() const noexcept { return *photograph_; }
  Steps texture(const TextureRecipe& recipe);

 private:
  std::shared_ptr<const GreyImage> photograph_{};
  std::string name_{};
  int threads_ = 1;

  // Each result is valid for `last_` and for the results before it, or is empty.
  TextureRecipe last_{};
  std::shared_ptr<const GreyImage> grey_{};
  std::optional<PictureSpectrum> logarithm_{};
  std::shared_ptr<const GreyImage> evened_{};
  std::shared_ptr<const GreyImage> low_pass_{};
  std::optional<Residual> residual_{};
};

}  // namespace asperity
