// Height fields and pictures on disk.

#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "results_schema/atomic_file.h"
#include "stimuli/heights/height_field.h"
#include "stimuli/heights/height_field_file.h"
#include "stimuli/pictures/grey_image.h"
#include "stimuli/pictures/photograph.h"

namespace asperity {

/// A height field as it was read: the heights, and the name of their content.
struct LoadedHeightField {
  std::shared_ptr<const HeightField> field{};
  /// Of the sidecar, which holds pitch and range of the heights and names the PNG by its SHA-256:
  /// two fields with the same one are the same relief.
  std::string sha256{};
};

/// Reads FILE.png and FILE.png.json and compares the PNG with the SHA-256 that the sidecar states.
///
/// Errors: ResultsError or std::invalid_argument, naming the file.
LoadedHeightField load_height_field(const std::filesystem::path& png);

/// What the sidecar says of how a height field came about. Errors: as `load_height_field`.
HeightFieldProvenance provenance_of(const std::filesystem::path& png);

std::filesystem::path sidecar_of(const std::filesystem::path& png);

/// Before the first of several files is written: refuses when one of them is there already.
///
/// Errors: ResultsError naming it.
void refuse_existing(const std::vector<std::filesystem::path>& files, Overwrite overwrite);

/// A PNG for people.
struct PictureFile {
  std::filesystem::path png{};
  std::string content{};  ///< the bytes of the file
};
/// In 8 bits.
PictureFile picture_file(const std::filesystem::path& png, const GreyImage& picture);

/// Writes FILE.png and FILE.png.json, and pictures of the same thing with them, as `write_files_together` does:
/// FILE.png is there with all the others or not at all. The program's version is noted in the provenance.
void save_height_field(const std::filesystem::path& png, const HeightField& field,
                       HeightFieldProvenance provenance, Overwrite overwrite,
                       const std::vector<PictureFile>& pictures = {});

/// An 8-bit PNG for people.
void save_picture(const std::filesystem::path& png, const GreyImage& picture, Overwrite overwrite);
void save_color_picture(const std::filesystem::path& png, const ColorPlanes& picture,
                        Overwrite overwrite);

/// A decoded photograph and the name of its content.
struct LoadedPhotograph {
  Photograph photograph{};
  std::string sha256{};
};
LoadedPhotograph load_photograph(const std::filesystem::path& file);
/// A picture with its colours.
ColorPlanes load_color_picture(const std::filesystem::path& file);

}  // namespace asperity
