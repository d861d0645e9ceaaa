// What is open in the workbench: a photograph with its previews, or a relief that is finished (of the study, or measured).

#pragma once

#include <filesystem>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include <QtCore/QStringList>
#include <QtGui/QImage>

#include "app/gui/workbench/texture_preview.h"
#include "app/study_files/height_field_files.h"
#include "stimuli/photographs/photograph_advice.h"

namespace asperity {

struct OpenedPicture {
  std::filesystem::path file{};
  TextureRecipe recipe{};  ///< when it was opened
  TexturePreview preview{};

  // Of a photograph; empty for a relief.
  LoadedPhotograph loaded{};
  std::shared_ptr<PhotographPreviews> resting{};  ///< in turn on every thread that has this
  std::shared_ptr<PhotographPreviews> dragged{};
  QImage original{};
  Phrase advice{};
  double direction_deg = 0.0;  ///< of the greatest change of brightness
  std::vector<PhotographResemblance> resemblances{};
  QStringList remarks{};  ///< sentences: what of the file counts in another way than one may think

  std::string sha256{};      ///< of a height field (LoadedHeightField); empty for others
  bool is_measured = false;  ///< the file of an instrument, levelled and without gaps

  bool is_photograph() const noexcept { return resting != nullptr; }
};

/// The photograph as participants are to see it, as a PNG: a PNG as it is, another format with the same pixels, in
/// colour where Qt reads it. Rows are those of the file, as the relief has them, whatever the camera noted.
///
/// Errors: a sentence, where the file has changed since it was opened.
std::string photograph_png(const OpenedPicture& opened);

/// A PNG that has a sidecar beside it.
bool is_height_field(const std::filesystem::path& file);

/// Reads the file and computes its first preview. Null when asked to stop. A measured surface (X3P, SUR or GWY) is
/// recognised by its content and converted as by surface_relief, with the plane subtracted.
///
/// Errors: a sentence, as a std::exception: what is no picture, cannot be read or is a folder; and
/// as texture_from_photograph. Any thread.
std::shared_ptr<const OpenedPicture> open_picture(const std::filesystem::path& file,
                                                  const TextureRecipe& recipe,
                                                  const std::stop_token& stop,
                                                  const std::function<void(double)>& progress);

}  // namespace asperity
