// Reads and writes height fields and pictures.

#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "results_schema/files/atomic_file.h"
#include "stimuli/heights/height_field.h"
#include "stimuli/heights/height_field_file.h"
#include "stimuli/pictures/grey_image.h"
#include "stimuli/pictures/photograph.h"

namespace asperity {

/// A height field with the hash of its content.
struct LoadedHeightField {
  std::shared_ptr<const HeightField> field{};
  /// Of the sidecar, which contains pitch and range of the heights and the SHA-256 of the PNG: two
  /// fields with the same hash are the same relief.
  std::string sha256{};
};

/// Reads FILE.png and FILE.png.json and compares the PNG with the SHA-256 that the sidecar states.
///
/// Errors: ResultsError or std::invalid_argument, naming the file.
LoadedHeightField load_height_field(const std::filesystem::path& png);

/// Height fields that are kept in memory, for one check of a protocol after another. Not for several threads at once.
class KeptHeightFields final {
 public:
  /// `load_height_field`, unless FILE.png and FILE.png.json have the times and sizes of the last call.
  ///
  /// Errors: as `load_height_field`.
  LoadedHeightField load(const std::filesystem::path& png);
  /// Removes the fields that have not been loaded since the last call.
  void forget_unused();

 private:
  /// The time and the size of a file; absent where there is no file.
  using FileState = std::optional<std::pair<std::filesystem::file_time_type, std::uintmax_t>>;
  struct Kept {
    std::array<FileState, 2> files{};  ///< the PNG and its sidecar, before they were read
    LoadedHeightField loaded{};
    bool is_used = true;
  };
  static FileState state_of(const std::filesystem::path& file);

  std::map<std::filesystem::path, Kept> kept_{};
};

/// Whether `load_height_field` would return this hash, without decoding the picture. False if a file is missing.
bool has_hash(const std::filesystem::path& png, const std::string& sha256);

/// How a height field was made, according to its sidecar. Errors: as `load_height_field`.
HeightFieldProvenance provenance_of(const std::filesystem::path& png);

std::filesystem::path sidecar_of(const std::filesystem::path& png);

/// Called before the first of several files is written: rejects a file that already exists.
///
/// Errors: ResultsError naming it.
void refuse_existing(const std::vector<std::filesystem::path>& files, Overwrite overwrite);

/// `write_files_together`, for a command with --force. Errors: also those of `refuse_existing`, for the last file and for
/// another one that has a different content.
void write_files_or_refuse(const std::vector<NewFile>& files, Overwrite overwrite);

/// A PNG for display.
struct PictureFile {
  std::filesystem::path png{};
  std::string content{};  ///< the bytes of the file
};
/// In 8 bits.
PictureFile picture_file(const std::filesystem::path& png, const GreyImage& picture);

/// Writes FILE.png and FILE.png.json, together with pictures of the same height field, as
/// `write_files_or_refuse` does: FILE.png exists with all the others or not at all. The program's
/// version is added to the provenance.
void save_height_field(const std::filesystem::path& png, const HeightField& field,
                       HeightFieldProvenance provenance, Overwrite overwrite,
                       const std::vector<PictureFile>& pictures = {});

/// Writes an 8-bit PNG for display.
void save_picture(const std::filesystem::path& png, const GreyImage& picture, Overwrite overwrite);
void save_color_picture(const std::filesystem::path& png, const ColorPlanes& picture,
                        Overwrite overwrite);

/// A decoded photograph with the hash of its content.
struct LoadedPhotograph {
  Photograph photograph{};
  std::string sha256{};
};
LoadedPhotograph load_photograph(const std::filesystem::path& file);
/// A picture with its colours.
ColorPlanes load_color_picture(const std::filesystem::path& file);

}  // namespace asperity
