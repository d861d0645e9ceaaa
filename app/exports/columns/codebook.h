// The codebook of an export: a row for each column of each of its files.

#pragma once

#include <string>
#include <vector>

#include "app/exports/columns/export_column.h"

namespace asperity {

/// The columns of codebook.tsv.
const std::vector<std::string>& codebook_columns();
/// The row that describes one column, in the order of `codebook_columns`.
std::vector<Cell> codebook_row(const std::string& file, const ExportColumn& column);

}  // namespace asperity
