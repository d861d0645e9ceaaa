// One table of a merged study, filled row by row. Seen by this folder only.

#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "results_schema/sqlite.h"

namespace asperity {

/// The value of a column in a merged study: that of the source, none, or another one.
struct Unchanged {};
struct Missing {};
using MergedValue = std::variant<Unchanged, Missing, std::int64_t, std::string>;

/// The value of a column of the row, whose number in the row is given, in the merged study.
using MergedValueOf = std::function<MergedValue(const std::string& column, Statement& row, int at)>;

/// Copies rows with all the columns that the table has, so that a column that a later schema adds is copied as well.
/// Errors: ResultsError, also for a row that the rules of the schema refuse.
class MergedTable final {
 public:
  MergedTable(Database& merged, std::string name);
  MergedTable(const MergedTable&) = delete;
  MergedTable& operator=(const MergedTable&) = delete;

  /// The place of a column in a row of a `selection`.
  int place_of(const std::string& column) const;
  /// "SELECT trial, block, … FROM trial " and the condition.
  std::string selection(const std::string& condition) const;

  /// Stores the row at which `row`, a `selection`, is. Returns its id where the table has one.
  std::int64_t add(Statement& row, const MergedValueOf& value_of);
  /// Stores every row of a selection with one parameter, a key of the source.
  void add_all(Database& source, const std::string& condition, std::int64_t key,
               const MergedValueOf& value_of);

 private:
  Database& merged_;
  std::string name_;
  std::vector<std::string> columns_;
  Statement insertion_;
};

/// The columns of a table, in their order.
std::vector<std::string> columns_of(Database& database, const std::string& table);

}  // namespace asperity
