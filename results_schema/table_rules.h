// The rules that stand in a database: its CHECK constraints with the rows that break them, and whether its tables,
// indices, triggers and views are still the program's. Seen by this folder only.

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

/// A sentence for each table, index, trigger and view that `database` lacks, has in another form, or has
/// beyond those of `made`: without them it no longer refuses what it should, or is read otherwise. Comments
/// and blanks make no difference, nor do what SQLite keeps for itself and views and indices of others, which
/// neither change nor refuse a row.
///
/// Errors: ResultsError.
std::vector<std::string> changed_objects(Database& database, Database& made);

}  // namespace asperity
