// The tables of an export with their columns.

#pragma once

#include <vector>

#include "app/exports/columns/export_column.h"
#include "app/exports/columns/study_vocabulary.h"

namespace asperity {

/// All tables of an export, in the order of the documentation.
std::vector<ExportFile> export_files(const StudyVocabulary& vocabulary);

/// The columns of a table with a row for each response to a trial's question, and one for an attempt without
/// responses: the trial, the result of the attempt, the surfaces and the response.
std::vector<ExportColumn> answered_trial_columns(const StudyVocabulary& vocabulary);

}  // namespace asperity
