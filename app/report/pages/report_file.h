// Writes a study's report to a file.

#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>

#include "results_schema/files/atomic_file.h"
#include "results_schema/study.h"

namespace asperity {

/// Checks a path before anything is read. Errors: std::invalid_argument for an extension other than
/// .pdf and .html; ResultsError for a folder that does not exist or cannot be written, and for a
/// file that already exists (with `refuse`).
void require_report_path(const std::filesystem::path& path, Overwrite overwrite);

/// Writes the report of a study (study_report.h) with its figures: a PDF or HTML according to the
/// extension of the path. Returns false, and writes nothing, when a stop was requested. `progress`
/// receives 0 to 1.
///
/// Requires a Qt application (LettersWithoutWindows, where there is no other); any thread. Errors:
/// those of require_report_path, study_report and write_file.
bool write_report(const Study& study, const std::filesystem::path& path, Overwrite overwrite,
                  const std::optional<std::string>& protocol = {}, const std::stop_token& stop = {},
                  const std::function<void(double)>& progress = {});

}  // namespace asperity
