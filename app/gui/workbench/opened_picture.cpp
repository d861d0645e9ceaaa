// Distinguishes height fields, measured surfaces and photographs, and refuses files it cannot use.

#include "app/gui/workbench/opened_picture.h"

#include <algorithm>
#include <new>
#include <span>
#include <stdexcept>

#include <QtCore/QBuffer>
#include <QtCore/QCoreApplication>
#include <QtCore/QFile>
#include <QtGui/QImageReader>

#include "app/gui/look/words.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/hashes/sha256.h"
#include "stimuli/measured/measured_surface.h"
#include "stimuli/measured/surface_relief.h"
#include "stimuli/photographs/preview.h"

namespace asperity {

namespace {

constexpr int kThumbnailSide = 1024;  // of the photograph in colour

struct OpeningWords {
  Q_DECLARE_TR_FUNCTIONS(OpeningWords)
};

[[noreturn]] void refuse(const QString& sentence) {
  throw std::runtime_error(sentence.toStdString());
}

/// What would block for ever, or fill the memory before anybody looks at it.
void refuse_what_is_no_file(const std::filesystem::path& file) {
  const QString name = path_text(file.filename());
  std::error_code error{};
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (std::filesystem::is_directory(status)) {
    refuse(OpeningWords::tr("%1 is a folder; open one of the pictures in it.").arg(name));
  }
  if (!std::filesystem::exists(status)) {
    refuse(OpeningWords::tr("%1 was not found; it may have been moved, or its disk removed. Open "
                            "the picture from its new location.")
               .arg(name));
  }
  if (!std::filesystem::is_regular_file(status)) {
    refuse(OpeningWords::tr("%1 is not a picture file; open a PNG, JPEG, TIFF, BMP or WebP file.")
               .arg(name));
  }
  const std::uintmax_t bytes = std::filesystem::file_size(file, error);
  if (!error && bytes > kPictureFile.most_bytes) {
    refuse(
        OpeningWords::tr(
            "%1 is %2 GiB in size; pictures of up to 2 GiB can be read. Scale it down or crop it.")
            .arg(name)
            .arg(shown_number(static_cast<double>(bytes) / (1U << 30U), 'f', 1)));
  }
}

[[noreturn]] void refuse_changed(const std::filesystem::path& file) {
  refuse(OpeningWords::tr("%1 has changed since it was opened. Open it again.")
             .arg(path_text(file.filename())));
}

/// In colour where Qt reads the format; its rows are those of the file, as in decode_photograph.
QImage colour_picture(const std::filesystem::path& file, const GreyImage& grey) {
  QImageReader reader(path_text(file));
  reader.setAutoTransform(false);
  const QSize size = reader.size();
  if (size.isValid() && std::max(size.width(), size.height()) > kThumbnailSide) {
    reader.setScaledSize(size.scaled(kThumbnailSide, kThumbnailSide, Qt::KeepAspectRatio));
  }
  // A pixel counts with its colour, however transparent: so it is shown.
  const QImage picture = reader.read().convertToFormat(QImage::Format_RGB32);
  return picture.isNull() ? picture_of(grey) : picture;
}

QStringList remarks_on(const std::filesystem::path& file, const PictureFacts& facts) {
  QStringList remarks{};
  if (facts.channels == 2 || facts.channels == 4) {
    remarks << OpeningWords::tr(
        "The picture has an alpha channel, which is ignored: each pixel is read with its full "
        "colour, regardless of its transparency.");
  }
  if (facts.format == PictureFormat::jpeg || facts.format == PictureFormat::tiff) {
    if (QImageReader(path_text(file)).transformation() != QImageIOHandler::TransformationNone) {
      remarks << OpeningWords::tr(
          "The camera stored a rotation with the picture; here the picture is shown without this "
          "rotation. If the orientation matters, rotate and save the picture with another "
          "program.");
    }
  }
  return remarks;
}

/// The relief of a measured surface; null for another file.
std::shared_ptr<const HeightField> measured_field(const std::filesystem::path& file) {
  const std::string content = read_file(file, kPictureFile);
  const std::span<const std::byte> bytes = std::as_bytes(std::span(content));
  const std::string name = file.filename().string();
  const auto format = surface_format_of(bytes, name);
  if (!format) return nullptr;
  if (*format == SurfaceFormat::tiff) {
    refuse(OpeningWords::tr("%1 contains heights, but neither their unit nor the width of the "
                            "surface. Convert it with “asperity texture”, and open the result.")
               .arg(path_text(file.filename())));
  }
  return std::make_shared<const HeightField>(
      surface_relief(decode_surface(bytes, {}, name), SurfaceForm::plane, name).field);
}

}  // namespace

std::string photograph_png(const OpenedPicture& opened) {
  const std::string content = read_file(opened.file, kPictureFile);
  if (sha256_of(content) != opened.loaded.sha256) refuse_changed(opened.file);
  if (opened.loaded.photograph.facts.format == PictureFormat::png) return content;
  QByteArray bytes =
      QByteArray::fromRawData(content.data(), static_cast<qsizetype>(content.size()));
  QBuffer source(&bytes);
  QImageReader reader(&source);
  reader.setAutoTransform(false);
  const QImage picture = reader.read();
  if (picture.isNull()) {
    return picture_file({}, opened.loaded.photograph.grey).content;
  }
  QByteArray png{};
  QBuffer target(&png);
  target.open(QIODevice::WriteOnly);
  // A pixel counts with its colour, however transparent.
  picture.convertToFormat(QImage::Format_RGB32).save(&target, "PNG");
  return png.toStdString();
}

bool is_height_field(const std::filesystem::path& file) {
  std::error_code error{};
  return file.extension() == ".png" && std::filesystem::exists(sidecar_of(file), error);
}

std::shared_ptr<const OpenedPicture> open_picture(const std::filesystem::path& file,
                                                  const TextureRecipe& recipe,
                                                  const std::stop_token& stop,
                                                  const std::function<void(double)>& progress) {
  refuse_what_is_no_file(file);
  auto opened = std::make_shared<OpenedPicture>();
  opened->file = file;
  opened->recipe = recipe;
  try {
    if (is_height_field(file)) {
      const LoadedHeightField stored = load_height_field(file);
      opened->sha256 = stored.sha256;
      opened->preview = preview_of(stored.field);
      return opened;
    }
    if (auto measured = measured_field(file)) {
      opened->is_measured = true;
      opened->preview = preview_of(std::move(measured));
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
    opened->direction_deg = direction_deg(evidence);
    opened->resemblances = resemblances(evidence);
    opened->original = colour_picture(file, shown);
    opened->remarks = remarks_on(file, opened->loaded.photograph.facts);
  } catch (const std::bad_alloc&) {
    refuse(OpeningWords::tr(
               "%1 does not fit into the memory of this computer. Scale it down or crop it.")
               .arg(path_text(file.filename())));
  }
  return opened;
}

}  // namespace asperity
