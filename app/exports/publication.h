// The sentences that describe what a public export contains and omits, and what can identify a participant.

#pragma once

#include <string>
#include <vector>

#include "app/exports/columns/export_column.h"
#include "app/exports/export_options.h"

namespace asperity {

/// States which columns of these files a public export for this audience omits, in which it withholds cells, and what it
/// keeps of a participant. Derived from the columns' `publication`, for README.txt and for the help of the command line.
std::string publication_text(const std::vector<ExportFile>& files, ExportAudience audience);

/// Lists which data of a public export with these options can still identify a participant.
std::string identifying_text(const ExportOptions& options);

/// Both for every study, without further options: NAME stands for a question about the participant.
std::string publication_text_of_any_study();

/// The entry in the list of omitted columns for the responses to this question of a questionnaire.
std::string left_out_answers_to(const std::string& question);

}  // namespace asperity
