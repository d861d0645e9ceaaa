// README.txt of an export.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/words/phrase.h"
#include "app/exports/export_options.h"

namespace asperity {

/// The text of README.txt. `remark` is about the condition of the study, `publication` describes what a public export
/// contains and omits.
std::string export_readme(const ExportOptions& options, const std::optional<Phrase>& remark,
                          const std::vector<Phrase>& warnings, const std::string& publication);

}  // namespace asperity
