// Result tables as programs read them: the flat table of --json, with which tests compare and from which they make results.

#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "analysis/words/phrase.h"
#include "app/findings/outcome/displayed_table.h"
#include "app/findings/outcome/result_table.h"
#include "results_schema/tables/table.h"

namespace asperity {

/// A result table with every value in a column of its own.
struct StoredTable {
  std::string name{};
  Phrase title{};
  Table table{};
  Phrase note{};
  bool lists_trials = false;
};

inline StoredTable stored(const ResultTable& result) {
  return {result.name, result.title, stored_table(result), result.note, result.lists_trials};
}

/// The result table with these values: `x_low` and `x_high` are the limits of an interval. Its columns have no headings.
inline ResultTable result_of(const StoredTable& stored) {
  ResultTable made{.name = stored.name,
                   .title = stored.title,
                   .note = stored.note,
                   .lists_trials = stored.lists_trials};
  std::vector<std::size_t> firsts{};
  for (std::size_t i = 0; i < stored.table.columns.size(); ++i) {
    const std::string& name = stored.table.columns[i];
    firsts.push_back(i);
    if (name.ends_with("_low")) {
      made.columns.push_back(interval_of({.id = name.substr(0, name.size() - 4)}));
      ++i;
    } else {
      made.columns.push_back({.id = name, .heading = name});
    }
  }
  for (const std::vector<Cell>& row : stored.table.rows) {
    ResultRow& cells = made.rows.emplace_back();
    for (std::size_t i = 0; i < made.columns.size(); ++i) {
      const std::size_t at = firsts[i];
      if (made.columns[i].part == ColumnPart::interval) {
        const auto limit = [&row](std::size_t place) -> std::optional<double> {
          const auto* const number = std::get_if<double>(&row.at(place));
          return number == nullptr ? std::nullopt : std::optional(*number);
        };
        cells.push_back(interval_cell(limit(at), limit(at + 1)));
      } else {
        std::visit([&cells](const auto& value) { cells.emplace_back(value); }, row.at(at));
      }
    }
  }
  return made;
}

inline std::vector<ResultTable> results_of(const std::vector<StoredTable>& stored) {
  std::vector<ResultTable> made{};
  for (const StoredTable& each : stored) made.push_back(result_of(each));
  return made;
}

/// The index of the column of this name.
inline std::optional<std::size_t> column_of(const Table& table, const std::string& name) {
  const auto found = std::find(table.columns.begin(), table.columns.end(), name);
  if (found == table.columns.end()) return {};
  return static_cast<std::size_t>(found - table.columns.begin());
}

/// A number, integer or not; nothing for text and missing cells.
inline std::optional<double> number_of(const Cell& cell) {
  if (const auto* whole = std::get_if<std::int64_t>(&cell)) return static_cast<double>(*whole);
  if (const auto* number = std::get_if<double>(&cell)) return *number;
  return {};
}

/// The cell of a number, or a missing one.
inline Cell cell_with(const std::optional<double>& number) {
  return number ? Cell{*number} : Cell{};
}

/// A table as a terminal shows it: the text of its cells, by the ids of its columns; "jnd 95 %" for an interval.
inline Table shown_table(const ResultTable& table) {
  const DisplayedTable shown = displayed(table, Reader::terminal);
  Table made{};
  for (const DisplayedColumn& column : shown.columns) {
    made.columns.push_back(column.heading.english());
  }
  for (const std::vector<Phrase>& row : shown.rows) {
    std::vector<Cell>& cells = made.rows.emplace_back();
    for (const Phrase& cell : row) cells.push_back(cell.empty() ? Cell{} : Cell{cell.english()});
  }
  return made;
}

}  // namespace asperity
