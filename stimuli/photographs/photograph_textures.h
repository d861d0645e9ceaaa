// Textures of one photograph under recipes that change, for whoever turns at them.

#pragma once

#include <memory>
#include <optional>
#include <string>

#include "stimuli/photographs/texture_steps.h"

namespace asperity {

/// The texture of `texture_from_photograph` under one recipe after another, bit for bit.
///
/// A recipe that differs from the one before in its last steps only costs those: amplitude and sign
/// a multiplication, the longest wave one filter, γ one and a half; width, light and histogram all.
/// Steps that a new recipe leaves as they were are the same objects as before.
///
/// Errors: as texture_from_photograph; the next recipe starts from what is sound.
///
/// Threads: one at a time calls `texture`, which has `threads` of its own work; the numbers do not
/// depend on how many.
class PhotographTextures final {
 public:
  struct Steps {
    std::shared_ptr<const HeightField> field{};
    std::shared_ptr<const GreyImage> grey{};      ///< as in PhotographTexture
    std::shared_ptr<const GreyImage> evened{};    ///< f
    std::shared_ptr<const GreyImage> low_pass{};  ///< g
  };

  /// `name` is the photograph's, for what is refused.
  PhotographTextures(GreyImage photograph, std::string name);
  PhotographTextures(GreyImage photograph, std::string name, int threads);

  const GreyImage& photograph() const noexcept { return *photograph_; }
  Steps texture(const TextureRecipe& recipe);

 private:
  std::shared_ptr<const GreyImage> photograph_{};
  std::string name_{};
  int threads_ = 1;

  // Each holds for `last_` and what stands before it, or is empty.
  TextureRecipe last_{};
  std::shared_ptr<const GreyImage> grey_{};
  std::optional<PictureSpectrum> logarithm_{};
  std::shared_ptr<const GreyImage> evened_{};
  std::shared_ptr<const GreyImage> low_pass_{};
  std::optional<Residual> residual_{};
};

}  // namespace asperity
