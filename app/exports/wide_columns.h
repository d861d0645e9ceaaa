// The columns and rows of the table with one row per participant, from the counts of their responses.

#pragma once

#include <string>
#include <vector>

#include "app/exports/columns/export_column.h"
#include "app/exports/columns/study_vocabulary.h"
#include "app/exports/wide_answers.h"

namespace asperity {

struct WideColumns {
  std::vector<ExportColumn> columns{};  ///< without the functions that make cells
  std::vector<std::vector<Cell>> rows{};
};

/// `about`: the columns of WideAnswers::Person::about. The names are valid and distinct in SPSS (sav_names).
WideColumns wide_columns(const WideAnswers& answers, std::vector<ExportColumn> about,
                         const StudyVocabulary& vocabulary);

}  // namespace asperity
