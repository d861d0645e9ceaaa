// Checks for repeated rows of a table: rejected where one row is required, reported where several
// are averaged.

#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "app/findings/tidy/finding_list.h"
#include "results_schema/tables/tidy_table.h"

namespace asperity {

/// Throws ResultsError with the place of the second row that has the same name in `column`; missing
/// names are not equal. `one_row`: the requirement ("one row per participant").
void refuse_repeated(const TidyTable& table, std::string_view column, const std::string& one_row);

/// The rows of one participant in one cell of the design, with display names.
struct CellRows {
  std::string participant{};
  std::string cell{};
  std::size_t rows = 0;  ///< with a value that counts; at least one
};
/// Reports what an analysis averages first: `cells.with.k`, how many cells have k values, and
/// `replicates`: "none" where every cell has one, "equal", or "unequal" with the sentence that
/// names the first cell whose number differs from that of most cells. Adds nothing without cells.
/// `participants`: the n of all of them.
void add_replicates(std::span<const CellRows> cells, std::size_t participants,
                    FindingList& findings);

}  // namespace asperity
