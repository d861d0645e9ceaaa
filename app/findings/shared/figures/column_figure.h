// Makes a figure of columns of a table of numbers.

#pragma once

#include <string>
#include <vector>

#include "app/findings/outcome/figure.h"
#include "results_schema/tables/table.h"

namespace asperity {

/// Which columns are drawn. The unit of a column is the end of its name: `fx_N`, `tz_N_m`, `rx_rad`, `time_s`.
struct ColumnChoice {
  std::string x{};
  std::vector<std::string> y{};  ///< with the same unit
};

/// Checks a choice before there are rows.
///
/// Errors: std::invalid_argument for a column that is missing, none to be drawn, one that is drawn twice, and columns with
/// different units, naming them.
void require_columns(const std::vector<std::string>& columns, const ColumnChoice& choice);

/// The columns over `x`, a line each, on linear axes that end at the outermost values. Rows without a number in a column
/// interrupt its line.
///
/// Errors: as `require_columns`.
Figure column_figure(const Table& table, const ColumnChoice& choice);

}  // namespace asperity
