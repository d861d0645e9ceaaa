// Records the outputs of a study outside its folder: exports, reports, copies.

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/words/phrase.h"
#include "results_schema/study.h"

namespace asperity {

/// Stores in the study that `path` was made from it, so that it can be found when a participant
/// withdraws. Call it when the output is complete. Returns the reason where it is not stored, for
/// example because the study is read-only here.
std::optional<Phrase> record_output(const Study& study, OutputKind kind,
                                    const std::filesystem::path& path);

/// "public export": the kind of output in lists.
Phrase kind_words(OutputKind kind);

/// The recorded outputs that may contain a participant's data. To be called before the participant's
/// rows are deleted: for a person, the outputs made since they were added. A simulated participant
/// has no real date; for those, the outputs that contain the label or cannot be read now.
/// Errors: ResultsError for an unknown label.
std::vector<OutputRow> outputs_of_participant(const Study& study, const std::string& label);

}  // namespace asperity
