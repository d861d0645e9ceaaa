// What the workbench shows of a photograph under one recipe.

#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include <QtGui/QImage>

#include "app/gui/workbench/relief_picture.h"
#include "stimuli/heights/height_field.h"
#include "stimuli/photographs/photograph_textures.h"
#include "stimuli/pictures/grey_image.h"

namespace asperity {

/// Longest sides in samples: of what a resting preview and one under a dragged control are computed
/// from, and of the meshes that are drawn.
inline constexpr std::size_t kPreviewSide = 1024;
inline constexpr std::size_t kDraggedSide = 384;
inline constexpr std::size_t kFineMeshSide = 512;
inline constexpr std::size_t kCoarseMeshSide = 192;

struct TexturePreview {
  std::shared_ptr<const HeightField> field{};
  /// Grey, evened, low-pass, heights; of a height field that came from a file the last alone.
  std::vector<QImage> steps{};
  QImage relief{};  ///< small, always seen from the same side
  std::shared_ptr<const ReliefMesh> fine{};
  std::shared_ptr<const ReliefMesh> coarse{};
};

TexturePreview preview_of(std::shared_ptr<const HeightField> field);

/// Previews of one photograph under one recipe after another: what a recipe leaves as it was is
/// neither computed nor drawn again.
///
/// Threads: any, one at a time.
class PhotographPreviews final {
 public:
  PhotographPreviews(GreyImage photograph, const std::string& name);

  const GreyImage& photograph() const noexcept { return textures_.photograph(); }
  /// Errors: as texture_from_photograph.
  TexturePreview under(const TextureRecipe& recipe);

 private:
  struct Drawn {
    std::shared_ptr<const GreyImage> step{};
    QImage picture{};
  };

  PhotographTextures textures_;
  std::array<Drawn, 3> drawn_{};  ///< grey, evened, low-pass
};

/// 8-bit; 0 is black, 1 white.
QImage picture_of(const GreyImage& image);

}  // namespace asperity
