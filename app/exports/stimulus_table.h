// Makes stimuli.tsv and stimuli/ of an export: the rendered stimuli, their height fields and
// forces.

#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "analysis/words/phrase.h"
#include "app/exports/columns/export_column.h"
#include "app/exports/export_folder.h"

namespace asperity {

/// One row per surface that sessions of one protocol and kind presented: stimulus, model, texture,
/// parameters; its height field with the features used in analyses of a relief; and the RMS of its
/// texture force, as matched and as achieved in the attempts that analyses count.
class StimulusTable final {
 public:
  /// Height fields are copied to `stimuli/` where that is requested.
  StimulusTable(ExportFolder& folder, std::filesystem::path study, bool copies_height_fields);

  static std::vector<ExportColumn> columns();

  /// `at` with a session: stores the paths of its files.
  void begin_session(const ExportPlace& at);
  /// `at` with a presentation.
  void add(const ExportPlace& at);
  /// Writes the table and copies the files. Returns a sentence for each height field that is no
  /// longer in the study as the sessions used it, with its stimuli and what to do.
  std::vector<Phrase> finish();

 private:
  struct Key {
    std::string protocol{};
    std::string version{};
    bool is_virtual = false;
    std::string mode{};
    std::string stimulus{};
    std::string model{};
    std::string model_version{};
    std::string texture{};
    std::string parameters_json{};
    std::optional<std::string> height_field_sha256{};
    std::optional<double> matched_texture_force_N{};
    auto operator<=>(const Key&) const = default;
  };
  struct Presented {
    std::int64_t presentations = 0;
    std::vector<double> achieved_N{};
  };
  enum class FileState { complete, missing, changed };
  struct Relief {
    FileState state = FileState::complete;
    std::string path{};  ///< within the study, and within the export where it was copied
    std::optional<double> width_m{};
    std::optional<double> rms_m{};
    std::optional<double> range_m{};
    std::optional<double> dominant_wavelength_m{};
  };
  static const char* name_of(FileState state);
  Relief relief_of(const std::string& sidecar_sha256);
  Phrase complaint_about(const std::string& sidecar_sha256, FileState state) const;

  ExportFolder& folder_;
  std::filesystem::path study_{};
  bool copies_height_fields_;
  std::map<std::string, std::string> paths_{};  ///< SHA-256 of a sidecar → its PNG
  std::map<Key, Presented> rows_{};
};

}  // namespace asperity
