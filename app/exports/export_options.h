// The settings of an export: audience, formats and published questions.

#pragma once

#include <set>
#include <string>

#include "app/exports/columns/export_column.h"
#include "app/exports/export_folder.h"
#include "app/exports/new_labels.h"

namespace asperity {

enum class ExportFormat {
  wide,     ///< wide.csv: one row per participant
  sav,      ///< trials.sav and wide.sav, for SPSS, PSPP, JASP and jamovi
  bids,     ///< Brain Imaging Data Structure
  psychds,  ///< Psych-DS
  physio,   ///< the recordings, all ticks, in the BIDS dataset
  fit,      ///< fit.tsv: counts at the levels of a numeric factor, for fits
  stimuli,  ///< the height fields that sessions used, with their sidecars
};

/// "wide", "sav", …, in the spelling of the command line.
const char* name_of(ExportFormat format) noexcept;
/// All except the recordings, which are larger than everything else together.
std::set<ExportFormat> usual_export_formats();

struct ExportOptions {
  ExportAudience audience = ExportAudience::own;
  Overwrite overwrite = Overwrite::refuse;
  /// Questions of questionnaires whose responses are also published. Errors: std::invalid_argument for a name that no
  /// questionnaire has, and for a question with free text.
  std::set<std::string> questions_for_public{};
  /// In addition to the tables and their codebook, which are always written.
  std::set<ExportFormat> formats = usual_export_formats();
  /// Of an export for `relabelled`, which draws its labels from them.
  RandomBits random_bits{};
  /// Exports bands of ages (AgeBands) in place of ages; for a public export only.
  bool has_age_bands = false;
};

}  // namespace asperity
