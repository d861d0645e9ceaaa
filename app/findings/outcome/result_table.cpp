// Finds cells by their columns, and divides intervals and joined cells into the columns of files.

#include "app/findings/outcome/result_table.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace asperity {

namespace {

Cell cell_of_limit(const std::optional<double>& limit) { return limit ? Cell{*limit} : Cell{}; }

/// Appends the values of a cell of `column`, one for each of its `names`.
void store(const ResultCell& cell, const ResultColumn& column, std::size_t names,
           std::vector<Cell>& row) {
  const std::size_t end = row.size() + names;
  if (const auto* const interval = std::get_if<Interval>(&cell)) {
    row.push_back(cell_of_limit(interval->low));
    row.push_back(cell_of_limit(interval->high));
  } else if (const auto* const joined = std::get_if<JoinedCell>(&cell)) {
    row.insert(row.end(), joined->stored.begin(), joined->stored.end());
  } else if (const auto* const quantity = std::get_if<Quantity>(&cell)) {
    row.emplace_back(quantity->value);
  } else if (const auto* const number = std::get_if<double>(&cell)) {
    row.emplace_back(*number);
  } else if (const auto* const count = std::get_if<std::int64_t>(&cell)) {
    row.emplace_back(*count);
  } else if (const auto* const word = std::get_if<std::string>(&cell)) {
    row.emplace_back(*word);
  }
  if (row.size() > end) throw std::logic_error("too many values for the column " + column.id);
  row.resize(end);
}

}  // namespace

std::vector<std::string> ResultColumn::stored_names() const {
  if (!stored_as.empty()) return stored_as;
  switch (part) {
    case ColumnPart::value:
      return {id};
    case ColumnPart::interval:
      return {id + "_low", id + "_high"};
    case ColumnPart::standard_error:
      return {id + "_se"};
  }
  return {};
}

ResultColumn interval_of(ResultColumn column, Phrase name) {
  column.part = ColumnPart::interval;
  column.interval_name = std::move(name);
  return column;
}

ResultColumn standard_error_of(ResultColumn column, Phrase heading) {
  column.part = ColumnPart::standard_error;
  column.heading = std::move(heading);
  return column;
}

ResultColumn for_files(ResultColumn column) {
  column.is_for_files = true;
  return column;
}

ResultCell cell_of(const std::optional<double>& value) {
  return value ? ResultCell{*value} : ResultCell{};
}

ResultCell word_cell(std::string text) {
  return text.empty() ? ResultCell{} : ResultCell{std::move(text)};
}

ResultCell quantity_cell(const std::optional<double>& value, const std::string& unit) {
  if (!value) return {};
  return unit.empty() ? ResultCell{*value} : ResultCell{Quantity{*value, unit}};
}

ResultCell interval_cell(std::optional<double> low, std::optional<double> high,
                         const std::string& unit) {
  return low || high ? ResultCell{Interval{low, high, unit}} : ResultCell{};
}

ResultCell count_cell(std::size_t count) { return static_cast<std::int64_t>(count); }

std::optional<std::size_t> ResultTable::find(const ResultColumn& column) const {
  const auto found = std::find_if(columns.begin(), columns.end(),
                                  [&column](const auto& each) { return each.is_same(column); });
  if (found == columns.end()) return {};
  return static_cast<std::size_t>(found - columns.begin());
}

bool ResultTable::has_values(const ResultColumn& column) const {
  const std::optional<std::size_t> at = find(column);
  return at && std::any_of(rows.begin(), rows.end(),
                           [&at](const ResultRow& row) { return row[*at] != ResultCell{}; });
}

void ResultTable::add(ResultRow row) {
  if (row.size() > columns.size()) throw std::logic_error("too many cells for the table " + name);
  row.resize(columns.size());
  rows.push_back(std::move(row));
}

void ResultTable::drop_empty_columns(std::size_t kept) {
  if (rows.empty()) return;
  for (std::size_t column = columns.size(); column-- > kept;) {
    const bool is_empty = std::all_of(rows.begin(), rows.end(), [column](const ResultRow& row) {
      return row[column] == ResultCell{};
    });
    if (!is_empty) continue;
    const auto at = static_cast<std::ptrdiff_t>(column);
    columns.erase(columns.begin() + at);
    for (ResultRow& row : rows) row.erase(row.begin() + at);
  }
}

const ResultCell& RowReader::cell(const ResultColumn& column) const {
  static const ResultCell kMissing{};
  const std::optional<std::size_t> at = table_.find(column);
  return at ? row_[*at] : kMissing;
}

std::string RowReader::text(const ResultColumn& column) const {
  const ResultCell& found = cell(column);
  if (const auto* const word = std::get_if<std::string>(&found)) return *word;
  const auto* const joined = std::get_if<JoinedCell>(&found);
  if (joined == nullptr || joined->stored.empty()) return {};
  const auto* const first = std::get_if<std::string>(&joined->stored.front());
  return first == nullptr ? std::string() : *first;
}

std::optional<double> RowReader::number(const ResultColumn& column) const {
  return number_of(cell(column));
}

Interval RowReader::interval(const ResultColumn& column) const {
  const auto* const found = std::get_if<Interval>(&cell(interval_of(column)));
  return found == nullptr ? Interval{} : *found;
}

std::optional<double> number_of(const ResultCell& cell) {
  if (const auto* const count = std::get_if<std::int64_t>(&cell))
    return static_cast<double>(*count);
  if (const auto* const number = std::get_if<double>(&cell)) return *number;
  if (const auto* const quantity = std::get_if<Quantity>(&cell)) return quantity->value;
  return {};
}

Table stored_table(const ResultTable& table) {
  Table stored{};
  std::vector<std::size_t> counts{};
  for (const ResultColumn& column : table.columns) {
    const std::vector<std::string> names = column.stored_names();
    counts.push_back(names.size());
    stored.columns.insert(stored.columns.end(), names.begin(), names.end());
  }
  for (const ResultRow& row : table.rows) {
    std::vector<Cell>& cells = stored.rows.emplace_back();
    for (std::size_t i = 0; i < row.size(); ++i)
      store(row[i], table.columns.at(i), counts[i], cells);
  }
  return stored;
}

}  // namespace asperity
