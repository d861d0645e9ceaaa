// The studies of a merge while they are read, and what speaks against merging them. Seen by this folder only.

#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "results_schema/merge/study_merge.h"
#include "results_schema/sqlite.h"
#include "results_schema/study.h"

namespace asperity {

/// A study at the moment of which it is read.
struct OpenSource {
  const MergeSource& source;
  const Study& study;
  Database& database;
};
using OpenSources = std::span<const OpenSource>;

/// "the study A cannot be merged: …"
[[noreturn]] void refuse_source(const MergeSource& source, const std::string& why);
/// "the studies A and B cannot be merged: …"
[[noreturn]] void refuse_pair(const MergeSource& first, const MergeSource& second,
                              const std::string& why);

/// Of one study: a deletion that is not complete, a session that is running, a protocol that its SHA-256 does not fit.
/// Errors: ResultsError.
void refuse_unfinished(const OpenSource& source);

/// Two copies of one study, or studies that were merged from a common one: they have a session, or a participant who is
/// not virtual, in common. Lists the participants of all studies in the temporary table `merged_participant` of `merged`:
/// `label`, the one in the merged study; `source`, the number of the study from 0; `id` there;
/// `form`, its label_form. Errors: ResultsError, also for labels of one form in two studies.
void list_participants(Database& merged, OpenSources sources);

/// Studies that were copied from one, if data were deleted from one of them and not from the other. Errors: ResultsError.
void refuse_undone_deletions(OpenSources sources);

/// What the studies state that state anything; `stated` precedes. Errors: ResultsError where they differ.
StudyMetadata merged_metadata(OpenSources sources, const StudyMetadata& stated);

/// When the study was created: copies of a study have this in common.
std::string creation_of(Database& database);

}  // namespace asperity
