// The CHECK constraints of a database's tables, and the rows that break them. Seen by this folder only.

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "results_schema/sqlite.h"

namespace asperity {

/// What stands in the parentheses of every CHECK of a CREATE TABLE, in order.
std::vector<std::string> checks_in(std::string_view create_table);

/// A sentence for each constraint that rows of a table break.
///
/// SQLite's own integrity check has none of them where it may only read: it leaves CHECK constraints out
/// of the schema of a database that cannot be written to (3.40, sqlite3AddCheckConstraint).
///
/// Errors: ResultsError.
std::vector<std::string> broken_checks(Database& database);

}  // namespace asperity
