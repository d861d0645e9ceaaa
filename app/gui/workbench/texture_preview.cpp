// Draws the steps that changed and the relief on several threads, and reuses the other pictures.

#include "app/gui/workbench/texture_preview.h"

#include <algorithm>
#include <atomic>
#include <functional>
#include <utility>

#include "stimuli/photographs/preview.h"
#include "stimuli/pictures/bands.h"

namespace asperity {

namespace {

constexpr std::size_t kShownSide = 512;  // of a step that is enlarged
constexpr QSize kSmallRelief{160, 120};

QImage step_picture(const GreyImage& step) {
  return picture_of(stretched(scaled_to_fit(step, kShownSide)));
}

/// Does what is to be done, the longest first, on as many threads as the machine has.
void do_at_once(const std::vector<std::function<void()>>& work) {
  std::atomic<std::size_t> next{0};
  in_bands(work.size(), usual_threads(), [&](std::size_t, std::size_t) {
    for (std::size_t i = next++; i < work.size(); i = next++) work[i]();
  });
}

/// Adds what draws the parts of a preview that follow from its heights.
void want_relief(TexturePreview& preview, std::vector<std::function<void()>>& work) {
  work.emplace_back([&preview] {
    preview.fine = std::make_shared<const ReliefMesh>(relief_mesh(*preview.field, kFineMeshSide));
  });
  work.emplace_back([&preview] {
    preview.coarse =
        std::make_shared<const ReliefMesh>(relief_mesh(*preview.field, kCoarseMeshSide));
    preview.relief = draw_relief(*preview.coarse, ReliefLook{}, kSmallRelief);
  });
  work.emplace_back([&preview] {
    const HeightField::Grid& grid = preview.field->grid();
    preview.steps.back() =
        step_picture(GreyImage{grid.rows, grid.columns, preview.field->heights_m()});
  });
}

}  // namespace

PhotographPreviews::PhotographPreviews(GreyImage photograph, const std::string& name)
    : textures_(std::move(photograph), name) {}

TexturePreview PhotographPreviews::under(const TextureRecipe& recipe) {
  const PhotographTextures::Steps steps = textures_.texture(recipe);
  TexturePreview preview{};
  preview.field = steps.field;
  preview.steps.resize(drawn_.size() + 1);
  std::vector<std::function<void()>> work{};
  want_relief(preview, work);
  const std::array computed{steps.grey, steps.evened, steps.low_pass};
  for (std::size_t i = 0; i < drawn_.size(); ++i) {
    if (drawn_[i].step == computed[i]) continue;
    work.emplace_back([this, i, step = computed[i]] {
      // Grey is brightness and stays as dark as it is; the others have no white of their own.
      drawn_[i] = {step,
                   i == 0 ? picture_of(scaled_to_fit(*step, kShownSide)) : step_picture(*step)};
    });
  }
  do_at_once(work);
  for (std::size_t i = 0; i < drawn_.size(); ++i) preview.steps[i] = drawn_[i].picture;
  return preview;
}

TexturePreview preview_of(std::shared_ptr<const HeightField> field) {
  TexturePreview preview{};
  preview.field = std::move(field);
  preview.steps.resize(1);
  std::vector<std::function<void()>> work{};
  want_relief(preview, work);
  do_at_once(work);
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
