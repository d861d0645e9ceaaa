// The answers of a study as columns of a tidy table, a row per answer.

#pragma once

#include "app/findings/study/gathered_answers.h"
#include "results_schema/tidy_table.h"

namespace asperity {

/// Who answered, by label.
LabelColumn column_of_people(const GatheredAnswers& gathered);
/// Response times in seconds; missing where there is none.
LabelColumn column_of_times(const GatheredAnswers& gathered);

}  // namespace asperity
