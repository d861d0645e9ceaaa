#include "app/gui/workbench/texture_preview.h"

#include <algorithm>
#include <utility>

#include "stimuli/preview.h"

namespace asperity {

namespace {

constexpr std::size_t kShownSide = 512;  // of a step that is enlarged

QImage step_picture(const GreyImage& step) {
  return picture_of(stretched(scaled_to_fit(step, kShownSide)));
}

void add_relief(TexturePreview& preview) {
  const HeightField::Grid& grid = preview.field->grid();
  preview.steps.push_back(
      step_picture(GreyImage{grid.rows, grid.columns, preview.field->heights_m()}));
  preview.coarse = std::make_shared<const ReliefMesh>(relief_mesh(*preview.field, kCoarseMeshSide));
  preview.fine = std::make_shared<const ReliefMesh>(relief_mesh(*preview.field, kFineMeshSide));
}

}  // namespace

TexturePreview preview_of(const GreyImage& photograph, const TextureRecipe& recipe,
                          const std::string& name) {
  PhotographTexture texture = texture_from_photograph(photograph, recipe, name);
  TexturePreview preview{};
  preview.steps = {picture_of(scaled_to_fit(texture.grey, kShownSide)),
                   step_picture(texture.evened), step_picture(texture.low_pass)};
  preview.field = std::make_shared<const HeightField>(std::move(texture.field));
  add_relief(preview);
  return preview;
}

TexturePreview preview_of(std::shared_ptr<const HeightField> field) {
  TexturePreview preview{};
  preview.field = std::move(field);
  add_relief(preview);
  return preview;
}

QImage picture_of(const GreyImage& image) {
  QImage picture(static_cast<int>(image.columns), static_cast<int>(image.rows),
                 QImage::Format_Grayscale8);
  for (std::size_t row = 0; row < image.rows; ++row) {
    uchar* line = picture.scanLine(static_cast<int>(row));
    for (std::size_t column = 0; column < image.columns; ++column) {
      const float value = image.values[row * image.columns + column];
      line[column] = static_cast<uchar>(255.0F * std::clamp(value, 0.0F, 1.0F) + 0.5F);
    }
  }
  return picture;
}

}  // namespace asperity
