#include "app/gui/workbench/opened_picture.h"

#include <algorithm>

#include <QtGui/QImageReader>

#include "stimuli/preview.h"

namespace asperity {

namespace {

constexpr int kThumbnailSide = 1024;  // of the photograph in colour

QString text_of(const std::filesystem::path& path) { return QString::fromStdString(path.string()); }

/// In colour where Qt reads the format; its rows are those of the file, as in decode_photograph.
QImage colour_picture(const std::filesystem::path& file, const GreyImage& grey) {
  QImageReader reader(text_of(file));
  reader.setAutoTransform(false);
  const QSize size = reader.size();
  if (size.isValid() && std::max(size.width(), size.height()) > kThumbnailSide) {
    reader.setScaledSize(size.scaled(kThumbnailSide, kThumbnailSide, Qt::KeepAspectRatio));
  }
  const QImage picture = reader.read();
  return picture.isNull() ? picture_of(grey) : picture;
}

}  // namespace

bool is_height_field(const std::filesystem::path& file) {
  std::error_code error{};
  return file.extension() == ".png" && std::filesystem::exists(sidecar_of(file), error);
}

std::shared_ptr<const OpenedPicture> open_picture(const std::filesystem::path& file,
                                                  const TextureRecipe& recipe,
                                                  const std::stop_token& stop,
                                                  const std::function<void(double)>& progress) {
  auto opened = std::make_shared<OpenedPicture>();
  opened->file = file;
  opened->recipe = recipe;
  if (is_height_field(file)) {
    opened->preview = preview_of(load_height_field(file).field);
    return opened;
  }
  opened->loaded = load_photograph(file);
  progress(0.5);
  if (stop.stop_requested()) return nullptr;
  const GreyImage& grey = opened->loaded.photograph.grey;
  const std::string name = file.filename().string();
  opened->resting = std::make_shared<PhotographPreviews>(scaled_to_fit(grey, kPreviewSide), name);
  opened->dragged = std::make_shared<PhotographPreviews>(scaled_to_fit(grey, kDraggedSide), name);
  opened->preview = opened->resting->under(recipe);
  progress(0.8);
  if (stop.stop_requested()) return nullptr;
  const GreyImage& shown = opened->resting->photograph();
  const PhotographEvidence evidence = examine_photograph(shown, recipe, name);
  opened->advice = advice(evidence);
  opened->resemblance = resemblance(evidence);
  opened->original = colour_picture(file, shown);
  return opened;
}

}  // namespace asperity
