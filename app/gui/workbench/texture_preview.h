// What the workbench shows of a photograph under one recipe.

#pragma once

#include <memory>
#include <string>
#include <vector>

#include <QtGui/QImage>

#include "app/gui/workbench/relief_picture.h"
#include "stimuli/grey_image.h"
#include "stimuli/height_field.h"
#include "stimuli/texture_from_photograph.h"

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
  std::shared_ptr<const ReliefMesh> fine{};
  std::shared_ptr<const ReliefMesh> coarse{};
};

/// Errors: as texture_from_photograph. Any thread.
TexturePreview preview_of(const GreyImage& photograph, const TextureRecipe& recipe,
                          const std::string& name);
TexturePreview preview_of(std::shared_ptr<const HeightField> field);

/// 8-bit; 0 is black, 1 white.
QImage picture_of(const GreyImage& image);

}  // namespace asperity
