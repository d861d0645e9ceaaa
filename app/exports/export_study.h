// Exports a study as files for other programs: tables, datasets, and scripts that load them.

#pragma once

#include <filesystem>
#include <functional>
#include <stop_token>
#include <vector>

#include "analysis/words/phrase.h"
#include "app/exports/export_folder.h"
#include "app/exports/export_options.h"
#include "renderers/force/force_model.h"
#include "results_schema/study.h"

namespace asperity {

/// The result of an export.
struct ExportOutcome {
  std::vector<ExportedFile> files{};  ///< by name; empty if the export was stopped
  /// Sentences on parts of the study that could not be exported, with a remedy. README.txt contains them.
  std::vector<Phrase> warnings{};
  /// The requested formats that were not written, and why.
  std::vector<Phrase> not_written{};
};

/// Checks what `export_study` refuses before it reads the study's rows. Errors: those of ExportFolder;
/// std::invalid_argument for a question whose answers cannot be published, and for bands of ages in an export that is not
/// public.
void refuse_export(const Study& study, const std::filesystem::path& folder,
                   const ExportOptions& options);

/// Writes a study into `folder`, which appears only when complete: docs/formats/export.md states
/// which files. After a stop there is no folder. `progress` receives 0 to 1.
///
/// Rows are ordered by natural keys and have no row ids, so that equal simulations export equal bytes. The tables contain
/// everything, including invalid, excluded and flagged attempts, pilot sessions and virtual participants, with columns
/// that state this. Files for direct analysis (the wide table, the SPSS files, the datasets) contain sessions of human
/// participants at the top level; pilot sessions are in `pilot/`, those of virtual participants in `virtual/`.
///
/// Everything is of one moment of the study. Where a participant's data are deleted meanwhile, the export begins again, and
/// does not contain them.
///
/// If the file of the study was changed, README.txt begins with a warning (Study::condition).
///
/// Memory: one session, and the wide table. Errors: those of refuse_export; ResultsError for a damaged study.
ExportOutcome export_study(const Study& study, const ModelRegistry& models,
                           const std::filesystem::path& folder, const ExportOptions& options,
                           const std::stop_token& stop = {},
                           const std::function<void(double)>& progress = {});

}  // namespace asperity
