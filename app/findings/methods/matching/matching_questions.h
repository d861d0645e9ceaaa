// Answers the questions of a matching in sentences, from its tests and tables.

#pragma once

#include <cstddef>

#include "app/findings/outcome/found_numbers.h"
#include "app/findings/outcome/study_findings.h"

namespace asperity {

/// Whether textures are matched to their pictures above chance.
void ask_items(const FoundNumbers& found, const StudyTests& tests, AnalysisOutcome& outcome);

/// How often all items of a trial are correct.
void ask_whole(const FoundNumbers& found, const StudyTests& tests, AnalysisOutcome& outcome);

/// Which textures are confused most often, from the table of confused pairs in `made`.
void ask_confused_pairs(const AnalysisOutcome& made, std::size_t people, AnalysisOutcome& outcome);

}  // namespace asperity
