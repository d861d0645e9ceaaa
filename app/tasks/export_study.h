// A study as tidy tables, for any program that reads text.

#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "app/tasks/export_columns.h"
#include "results_schema/atomic_file.h"
#include "results_schema/study.h"
#include "results_schema/table.h"

namespace asperity {

/// `published`: without dates and without anything that somebody typed freely.
enum class ExportAudience { own, published };

struct ExportTable {
  std::string name{};  ///< of the file, without ".tsv"
  Table table{};
  std::vector<std::string> left_out{};  ///< columns that this audience does not get
};

struct ExportTables {
  std::vector<ExportTable> tables{};
  Table codebook{};
};

/// Every table of the study and the codebook. Rows are ordered by natural keys and carry no row
/// ids, so that two simulations that did the same export the same bytes. Nothing is left out for
/// being invalid, flagged, virtual or of a pilot: columns say so.
///
/// When asked to stop, what there is by then. `progress` is told 0 to 1.
ExportTables export_tables(const Study& study, ExportAudience audience,
                           const std::stop_token& stop = {},
                           const std::function<void(double)>& progress = {});

struct ExportedFile {
  std::string name{};
  std::size_t rows = 0;            ///< without the one that names the columns
  std::size_t replaced_cells = 0;  ///< text with tabs or line breaks, which became spaces
};

/// Writes the tables, codebook.tsv and MANIFEST.tsv (rows and SHA-256 of each) into `folder`, which
/// appears complete or not at all. Returns every file in it; when asked to stop, none, and leaves
/// nothing behind.
///
/// Errors: ResultsError when `folder` exists and is not empty; with Overwrite::allow only when it
/// holds something that no export wrote, because it would be lost.
std::vector<ExportedFile> export_study(const Study& study, const std::filesystem::path& folder,
                                       ExportAudience audience, Overwrite overwrite,
                                       const std::stop_token& stop = {},
                                       const std::function<void(double)>& progress = {});

}  // namespace asperity
