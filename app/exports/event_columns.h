// The columns of events.tsv: whatever happened in a session apart from answers.

#pragma once

#include <vector>

#include "app/exports/columns.h"

namespace asperity {

std::vector<ExportColumn> event_columns();

}  // namespace asperity
