// A study as files for other programs: tables, datasets, and scripts that load them.

#pragma once

#include <filesystem>
#include <functional>
#include <set>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "app/exports/columns/export_column.h"
#include "app/exports/export_folder.h"
#include "app/words/phrase.h"
#include "renderers/force/force_model.h"
#include "results_schema/study.h"

namespace asperity {

enum class ExportFormat {
  wide,     ///< wide.csv: one row per participant
  sav,      ///< trials.sav and wide.sav, for SPSS, PSPP, JASP and jamovi
  bids,     ///< Brain Imaging Data Structure
  psychds,  ///< Psych-DS
  physio,   ///< the recordings, tick by tick, in the BIDS dataset
  fit,      ///< fit.tsv: counts at the levels of a numeric factor, as fits take them
  stimuli,  ///< the height fields that sessions used, with their sidecars
};

/// "wide", "sav", …, as the command line spells them.
const char* name_of(ExportFormat format) noexcept;
/// All but the recordings, which are larger than everything else together.
std::set<ExportFormat> usual_export_formats();

struct ExportOptions {
  ExportAudience audience = ExportAudience::own;
  Overwrite overwrite = Overwrite::refuse;
  /// Questions of questionnaires whose answers are published as well. Errors: std::invalid_argument
  /// for one that no questionnaire asks, or whose answer is free text.
  std::set<std::string> questions_for_public{};
  /// In addition to the tables and their codebook, which are always written.
  std::set<ExportFormat> formats = usual_export_formats();
};

/// The result of an export.
struct ExportOutcome {
  std::vector<ExportedFile> files{};  ///< by name; none when it was asked to stop
  /// What of the study could not be exported, and what to do, a sentence each. README.txt has them too.
  std::vector<Phrase> warnings{};
  /// The requested formats that were not written, and why.
  std::vector<Phrase> not_written{};
};

/// Writes a study into `folder`, which appears only when complete: docs/formats/export.md states
/// which files. When asked to stop it leaves nothing behind. `progress` receives 0 to 1.
///
/// Rows are ordered by natural keys and carry no row ids, so that two simulations that did the same
/// export the same bytes. From the tables nothing is left out for being invalid, excluded, flagged,
/// virtual or of a pilot: columns state it. What is meant to be analysed as it is (the wide table, the
/// SPSS files, the datasets) has people's sessions at the top; those of a pilot are in `pilot/`,
/// those of virtual participants in `virtual/`.
///
/// README.txt begins with it when the study's file was changed (Study::condition).
///
/// Memory: what one session needs, and the wide table. Errors: as ExportFolder's; ResultsError for a
/// study that is broken.
ExportOutcome export_study(const Study& study, const ModelRegistry& models,
                           const std::filesystem::path& folder, const ExportOptions& options,
                           const std::stop_token& stop = {},
                           const std::function<void(double)>& progress = {});

}  // namespace asperity
