// Takes the most frequent number of values of a cell as the expected one.

#include "app/findings/tidy/repeated_rows.h"

#include <algorithm>
#include <map>
#include <vector>

namespace asperity {
namespace {

std::string values_of(std::size_t values) {
  return values == 1 ? "1 value" : std::to_string(values) + " values";
}

}  // namespace

void refuse_repeated(const TidyTable& table, std::string_view column, const std::string& one_row) {
  const LabelColumn labels = table.labels(column);
  std::vector<bool> seen(labels.names.size());
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::size_t name = labels.codes[row];
    if (name == LabelColumn::kMissing) continue;
    if (seen[name]) {
      table.refuse(row, column,
                   '"' + labels.names[name] + "\" occurs a second time; there must be " + one_row +
                       ". Remove or rename one of the rows");
    }
    seen[name] = true;
  }
}

void add_replicates(std::span<const CellRows> cells, std::size_t participants,
                    FindingList& findings) {
  if (cells.empty()) return;
  std::map<std::size_t, std::size_t> cells_with{};
  for (const CellRows& cell : cells) ++cells_with[cell.rows];
  const auto most = std::max_element(
      cells_with.begin(), cells_with.end(),
      [](const auto& one, const auto& other) { return one.second < other.second; });
  const Basis basis{
      .n = participants,
      .method =
          "participants' cells with this number of values; the values of a cell are averaged"};
  for (const auto& [rows, count] : cells_with) {
    findings.count("cells.with.k", std::to_string(rows), count, basis);
  }
  const Basis told{
      .n = participants,
      .method = "whether a participant has several values in a cell; these are averaged first"};
  if (cells_with.size() == 1) {
    findings.word("replicates", "", most->first == 1 ? "none" : "equal", "ok", told);
    return;
  }
  const auto other = std::find_if(cells.begin(), cells.end(), [&most](const CellRows& cell) {
    return cell.rows != most->first;
  });
  const std::size_t others = cells.size() - most->second;
  findings.word("replicates", "", "unequal",
                other->participant + " has " + values_of(other->rows) + " in the cell " +
                    other->cell + ", while " + std::to_string(most->second) + " of " +
                    std::to_string(cells.size()) +
                    (most->second == 1 ? " cells has " : " cells have ") + values_of(most->first) +
                    (others > 1 ? "; " + std::to_string(others) + " cells differ from these" : "") +
                    ". The values of a cell are averaged: check whether a row " +
                    (other->rows > most->first ? "occurs twice"
                                               : "is missing or has no value that "
                                                 "counts") +
                    ", or has the wrong participant or cell",
                told);
}

}  // namespace asperity
