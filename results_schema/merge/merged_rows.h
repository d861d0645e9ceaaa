// The rows of a merged study, copied from those of its sources. Seen by this folder only.

#pragma once

#include <filesystem>

#include "results_schema/merge/merge_sources.h"
#include "results_schema/sqlite.h"

namespace asperity {

/// Where a file of a source goes: the folders and the sheet of a participant have the label in their name.
std::filesystem::path merged_path(const MergeSource& source, const std::filesystem::path& path);

/// Fills the new study `merged` with the rows of its sources, whose participants `list_participants` has listed, in the
/// order of natural keys: the same rows give the same file, whatever the order of the sources. Row by row, through the
/// rules of the schema. Errors: ResultsError, also for a protocol of which two studies state different things.
///
/// The list of outputs stays with each study: it is of what was made of that study.
void copy_merged_rows(Database& merged, OpenSources sources);

}  // namespace asperity
