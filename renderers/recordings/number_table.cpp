// Implements the reading of a table of numbers.

#include "renderers/recordings/number_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "analysis/numbers/look_alikes.h"
#include "analysis/numbers/number_text.h"

namespace asperity {
namespace {

std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells{};
  while (true) {
    const std::size_t tab = line.find('\t');
    cells.push_back(line.substr(0, tab));
    if (tab == std::string_view::npos) return cells;
    line.remove_prefix(tab + 1);
  }
}

}  // namespace

void refuse_table_line(const std::string& name, std::size_t line, const std::string& problem) {
  throw std::invalid_argument(name + ':' + std::to_string(line) + ": " + problem);
}

NumberTable number_table_in(
    std::string_view tsv, const std::string& name,
    const std::function<void(const std::vector<std::string>&)>& check_columns) {
  NumberTable table{};
  std::size_t line_number = 0;
  tsv = without_byte_order_mark(tsv);
  if (tsv.find('\n') == std::string_view::npos && tsv.find('\r') != std::string_view::npos) {
    refuse_table_line(name, 1,
                      "the lines end with carriage returns alone; save the table with line feeds "
                      "(LF or CRLF)");
  }
  do {
    const std::size_t end = std::min(tsv.find('\n'), tsv.size());
    std::string_view line = tsv.substr(0, end);
    tsv.remove_prefix(std::min(end + 1, tsv.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    ++line_number;
    if (line_number > 1 && line.empty()) continue;
    const std::vector<std::string_view> cells = cells_of(line);
    if (line_number == 1) {
      table.columns.assign(cells.begin(), cells.end());
      check_columns(table.columns);
      continue;
    }
    if (cells.size() != table.columns.size()) {
      refuse_table_line(name, line_number,
                        "the row has " + counted(cells.size(), "cell", "cells") +
                            "; give it one cell for each of the columns, " +
                            std::to_string(table.columns.size()));
    }
    NumberTable::Row row{.line = line_number, .cells = std::vector<double>(cells.size())};
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::string_view cell = cells[i];
      const auto read = std::from_chars(cell.data(), cell.data() + cell.size(), row.cells[i]);
      if (read.ec != std::errc() || read.ptr != cell.data() + cell.size() ||
          !std::isfinite(row.cells[i])) {
        refuse_table_line(name, line_number,
                          "the column " + table.columns[i] + " has \"" + std::string(cell) +
                              "\", " + number_correction(cell));
      }
    }
    table.rows.push_back(std::move(row));
  } while (!tsv.empty());
  return table;
}

}  // namespace asperity
