// The sentences that describe what a public export contains and omits.

#pragma once

#include <string>
#include <vector>

#include "app/exports/columns/export_column.h"

namespace asperity {

/// States which columns of these files a public export omits, in which it withholds cells, and what it keeps of a
/// participant. Derived from the columns' `publication`, for README.txt and for the help of the command line.
std::string publication_text(const std::vector<ExportFile>& files);

/// The same for every study: NAME stands for a question about the participant.
std::string publication_text_of_any_study();

/// The entry in the list of omitted columns for the responses to this question of a questionnaire.
std::string left_out_answers_to(const std::string& question);

}  // namespace asperity
