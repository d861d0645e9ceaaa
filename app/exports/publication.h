// What an export for the public has and lacks, in sentences.

#pragma once

#include <string>
#include <vector>

#include "app/exports/columns.h"

namespace asperity {

/// Which columns of these files an export for the public leaves out, in which it withholds cells, and what it keeps of a
/// participant. Made of the columns' `publication`, for README.txt and for the help of the command line.
std::string publication_text(const std::vector<ExportFile>& files);

/// The same of a study whatever its protocols ask: NAME stands for a question about the participant.
std::string publication_text_of_any_study();

}  // namespace asperity
