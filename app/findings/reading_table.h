// Tables of an analysis as people read them.

#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "results_schema/table.h"

namespace asperity {

/// Where the column of this name is.
std::optional<std::size_t> column_of(const Table& table, const std::string& name);

/// Whether any row has something in this column; false where there is no such column.
bool has_cells(const Table& table, const std::string& column);

/// A number, whole or not; nothing for text and what is missing.
std::optional<double> number_of(const Cell& cell);

/// Without the columns that have nothing in any row, but for the first `kept` ones. A table without rows stays.
void drop_empty_columns(Table& table, std::size_t kept);

/// The same table with every number in the digits that mean something (a share to two decimals, a
/// force to a millinewton, a length to ten micrometres, a p to three decimals or "< .001"), and
/// `x_low` and `x_high` as one column: "[0.36, 0.81]". Numbers are shortened here and nowhere
/// before. Whole numbers stay numbers; everything else is text or missing.
Table reading_table(const Table& table);

}  // namespace asperity
