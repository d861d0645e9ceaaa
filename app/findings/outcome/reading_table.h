// Formats the tables of an analysis for display.

#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "results_schema/tables/table.h"

namespace asperity {

/// The index of the column of this name.
std::optional<std::size_t> column_of(const Table& table, const std::string& name);

/// Whether any row has a value in this column; false where there is no such column.
bool has_cells(const Table& table, const std::string& column);

/// A number, integer or not; nothing for text and missing cells.
std::optional<double> number_of(const Cell& cell);

/// Removes the columns that are empty in every row, except the first `kept` ones. A table without
/// rows is unchanged.
void drop_empty_columns(Table& table, std::size_t kept);

/// The same table with its numbers rounded to their significant digits, and `x_low` and `x_high` combined in one column: "[0.36,
/// 0.81]". A force is rounded to a millinewton, a length to ten micrometres, a p to three decimals or "< .001", a test statistic to
/// two decimals; all other numbers of a quantity, with their intervals and standard errors, to the same number of decimals:
/// `decimals_of` the narrowest interval, or without intervals two and more for small numbers. Numbers are rounded here and
/// nowhere before. Integers stay numbers; everything else becomes text or missing.
Table reading_table(const Table& table);

}  // namespace asperity
