// Inserts rows with the values of the source, except for columns that the caller replaces.

#include "results_schema/merge/merged_table.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

namespace asperity {
namespace {

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::string insertion_into(const std::string& table, const std::vector<std::string>& columns) {
  const std::vector<std::string> marks(columns.size(), "?");
  return "INSERT INTO " + table + " (" + joined(columns) + ") VALUES (" + joined(marks) + ')';
}

}  // namespace

std::vector<std::string> columns_of(Database& database, const std::string& table) {
  Statement statement(database, "SELECT name FROM pragma_table_info(?) ORDER BY cid");
  statement.bind(table);
  std::vector<std::string> columns;
  while (statement.step()) statement.read(columns.emplace_back());
  return columns;
}

MergedTable::MergedTable(Database& merged, std::string name)
    : merged_(merged),
      name_(std::move(name)),
      columns_(columns_of(merged, name_)),
      insertion_(merged, insertion_into(name_, columns_)) {}

int MergedTable::place_of(const std::string& column) const {
  return static_cast<int>(std::find(columns_.begin(), columns_.end(), column) - columns_.begin());
}

std::string MergedTable::selection(const std::string& condition) const {
  return "SELECT " + joined(columns_) + " FROM " + name_ + ' ' + condition;
}

std::int64_t MergedTable::add(Statement& row, const MergedValueOf& value_of) {
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const int at = static_cast<int>(i);
    const MergedValue value = value_of(columns_[i], row, at);
    if (std::holds_alternative<Unchanged>(value)) {
      insertion_.bind_column(row, at);
    } else if (std::holds_alternative<Missing>(value)) {
      insertion_.bind(std::nullopt);
    } else if (const auto* const number = std::get_if<std::int64_t>(&value)) {
      insertion_.bind(*number);
    } else {
      insertion_.bind(std::get<std::string>(value));
    }
  }
  insertion_.run();
  return merged_.last_row_id();
}

void MergedTable::add_all(Database& source, const std::string& condition, std::int64_t key,
                          const MergedValueOf& value_of) {
  Statement row(source, selection(condition));
  row.bind(key);
  while (row.step()) add(row, value_of);
}

}  // namespace asperity
