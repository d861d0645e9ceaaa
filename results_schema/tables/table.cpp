// Tab-separated text, written and read.

#include "results_schema/tables/table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

#include "results_schema/study.h"
#include "results_schema/tables/table_words.h"

namespace asperity {
namespace {

/// Appends `text` with what would break a row turned into spaces. Returns whether it changed.
bool append_cell(std::string& line, std::string_view text) {
  bool changed = false;
  for (const char character : text) {
    const bool breaks = character == '\t' || character == '\n' || character == '\r';
    line += breaks ? ' ' : character;
    changed = changed || breaks;
  }
  return changed;
}

std::vector<std::string_view> split(std::string_view line) {
  std::vector<std::string_view> cells;
  for (;;) {
    const std::size_t tab = line.find('\t');
    cells.push_back(line.substr(0, tab));
    if (tab == std::string_view::npos) return cells;
    line.remove_prefix(tab + 1);
  }
}

}  // namespace

std::string tsv_of(const Table& table, std::size_t* replaced) {
  std::size_t changed_cells = 0;
  std::string text;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    if (i > 0) text += '\t';
    if (append_cell(text, table.columns[i])) ++changed_cells;
  }
  text += '\n';
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const auto& cells = table.rows[row];
    if (cells.size() != table.columns.size()) {
      throw std::invalid_argument("rows: the number of cells in row " + std::to_string(row + 1) +
                                  " is " + std::to_string(cells.size()) +
                                  "; it must be the number of columns, " +
                                  std::to_string(table.columns.size()));
    }
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (i > 0) text += '\t';
      if (const auto* whole = std::get_if<std::int64_t>(&cells[i])) {
        text += std::to_string(*whole);
      } else if (const auto* number = std::get_if<double>(&cells[i])) {
        text += text_of_number(*number);
      } else if (const auto* words = std::get_if<std::string>(&cells[i])) {
        if (append_cell(text, *words) || *words == kMissingCell) ++changed_cells;
      } else {
        text += kMissingCell;
      }
    }
    text += '\n';
  }
  if (replaced != nullptr) *replaced = changed_cells;
  return text;
}

Table read_tsv(std::string_view text, const std::string& file_name) {
  text = text_of_table(text, file_name);
  if (text.empty())
    throw ResultsError(
        file_name + ":1:1: the header line is missing; add a line with the names of the columns",
        file_name);
  Table table;
  for (std::size_t line_number = 1; !text.empty(); ++line_number) {
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    const std::vector<std::string_view> cells = split(line);
    const std::string place = file_name + ":" + std::to_string(line_number) + ":";
    if (line_number == 1) {
      std::set<std::string_view> seen;
      for (std::size_t i = 0; i < cells.size(); ++i) {
        if (cells[i].empty()) {
          throw ResultsError(
              place + std::to_string(i + 1) + ": the column has no name; give it one", file_name);
        }
        if (!seen.insert(cells[i]).second) {
          throw ResultsError(place + std::to_string(i + 1) + ": the column name \"" +
                                 std::string(cells[i]) +
                                 "\" occurs twice; rename one of the columns",
                             file_name);
        }
        table.columns.emplace_back(cells[i]);
      }
      continue;
    }
    if (cells.size() != table.columns.size()) {
      throw ResultsError(place + std::to_string(std::min(cells.size(), table.columns.size()) + 1) +
                             ": the row has " + std::to_string(cells.size()) +
                             (cells.size() == 1 ? " cell" : " cells") + ", the header has " +
                             std::to_string(table.columns.size()) +
                             (table.columns.size() == 1 ? " column" : " columns") +
                             "; give each row one cell per column",
                         file_name);
    }
    std::vector<Cell>& row = table.rows.emplace_back();
    for (const std::string_view cell : cells) {
      if (cell == kMissingCell) {
        row.emplace_back();
      } else {
        row.emplace_back(std::string(cell));
      }
    }
  }
  return table;
}

std::string text_of_number(double value) {
  if (std::isnan(value)) return "nan";  // to_chars would tell a negative one apart
  char buffer[32];
  const auto result = std::to_chars(buffer, buffer + sizeof buffer, value);
  return std::string(buffer, result.ptr);
}

std::optional<double> number_in(std::string_view text) {
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  if (result.ec != std::errc() || result.ptr != end) return std::nullopt;
  return value;
}

bool precedes_by_value(std::string_view one, std::string_view other) {
  const std::optional<double> first = number_in(one);
  const std::optional<double> second = number_in(other);
  if (first.has_value() != second.has_value()) return first.has_value();
  return first && *first != *second ? *first < *second : one < other;
}

}  // namespace asperity
