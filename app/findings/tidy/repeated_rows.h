// Rows of a table that are about the same thing: refused where one has to be, told where several are
// averaged.

#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "app/findings/tidy/finding_list.h"
#include "results_schema/tidy_table.h"

namespace asperity {

/// Throws ResultsError with the place of the second row that has the same name in `column`; missing
/// names are not the same. `one_row`: what there is one row of ("one row per participant").
void refuse_repeated(const TidyTable& table, std::string_view column, const std::string& one_row);

/// The rows of one participant in one cell of the design, as people read both names.
struct CellRows {
  std::string participant{};
  std::string cell{};
  std::size_t rows = 0;  ///< with a value that counts; one or more
};
/// What an analysis averages before all else: `cells.with.k`, how many cells have k values,
/// and `replicates`: "none" where every cell has one, "equal", or "unequal" with the sentence that names
/// the first cell with another number than most. Nothing for no cells. `participants`: the
/// n of all of them.
void add_replicates(std::span<const CellRows> cells, std::size_t participants,
                    FindingList& findings);

}  // namespace asperity
