// A study's report from its rows to a file.

#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>

#include "results_schema/atomic_file.h"
#include "results_schema/study.h"

namespace asperity {

/// What can be said of a path before anything is read. Errors: std::invalid_argument for an ending
/// other than .pdf and .html; ResultsError for a folder that is not there or takes no files, and for
/// a file that is there already (and `refuse`).
void require_report_path(const std::filesystem::path& path, Overwrite overwrite);

/// Writes the report of a study (study_report.h) with its figures: a PDF or HTML by the ending of
/// the path. False, and nothing written, when asked to stop. `progress` is told 0 to 1.
///
/// Where there is an application of Qt (LettersWithoutWindows, where there is no other); any thread.
/// Errors: as above, as study_report and as write_file.
bool write_report(const Study& study, const std::filesystem::path& path, Overwrite overwrite,
                  const std::optional<std::string>& protocol = {}, const std::stop_token& stop = {},
                  const std::function<void(double)>& progress = {});

}  // namespace asperity
