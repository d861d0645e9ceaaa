// The files of a power analysis in its folder.

#pragma once

#include <filesystem>

#include "results_schema/files/atomic_file.h"

namespace asperity {

/// The simulated studies (app/power/curve/study_rows.h).
inline constexpr const char* kStudiesFile = "studies.tsv";
/// How `studies.tsv` was made: `declaration_of`.
inline constexpr const char* kDeclarationFile = "studies.tsv.json";

/// The figures that were drawn from `studies.tsv`: DrawnFigures.
inline constexpr const char* kFiguresFile = "figures.json";

struct PowerFiles {
  std::filesystem::path
      folder{};  ///< made where it is missing; the folder that it is in must exist
  Overwrite overwrite = Overwrite::refuse;  ///< of the studies of another order

  std::filesystem::path studies() const { return folder / kStudiesFile; }
  std::filesystem::path declaration() const { return folder / kDeclarationFile; }
  std::filesystem::path figures() const { return folder / kFiguresFile; }
};

/// Makes the folder where it is missing. Errors: std::runtime_error where the folder that it is in is missing; ResultsError.
void make_folder(const PowerFiles& files);

}  // namespace asperity
