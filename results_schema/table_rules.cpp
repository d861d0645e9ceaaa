// Parses CHECK constraints from the stored SQL, and compares objects with those of a new database.

#include "results_schema/table_rules.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>

namespace asperity {
namespace {

bool is_of_a_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         static_cast<unsigned char>(c) >= 0x80;
}

/// Where what stands at `at` ends, if it is a comment, a literal or a quoted name, in which nothing means
/// anything; `at` otherwise.
std::size_t past_quoted(std::string_view sql, std::size_t at) {
  const auto past = [sql](std::string_view end, std::size_t from) {
    const std::size_t found = sql.find(end, from);
    return found == std::string_view::npos ? sql.size() : found + end.size();
  };
  if (sql.substr(at, 2) == "--") return past("\n", at);
  if (sql.substr(at, 2) == "/*") return past("*/", at + 2);
  switch (sql[at]) {
    case '\'':
    case '"':
    case '`':  // written twice inside, a quote ends one and begins the next
      return past(sql.substr(at, 1), at + 1);
    case '[':
      return past("]", at);
    default:
      return at;
  }
}

/// The place of the parenthesis that closes the one at `open`.
std::size_t closing(std::string_view sql, std::size_t open) {
  int depth = 0;
  for (std::size_t at = open; at < sql.size();) {
    if (const std::size_t past = past_quoted(sql, at); past != at) {
      at = past;
      continue;
    }
    if (sql[at] == '(') ++depth;
    if (sql[at] == ')' && --depth == 0) return at;
    ++at;
  }
  return sql.size();
}

bool is_check(std::string_view word) {
  constexpr std::string_view kCheck = "check";
  return std::equal(word.begin(), word.end(), kCheck.begin(), kCheck.end(),
                    [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; });
}

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

/// A statement without its comments, with one blank wherever there were some.
std::string bare_statement(std::string_view sql) {
  std::string bare;
  for (std::size_t at = 0; at < sql.size();) {
    const std::size_t past = past_quoted(sql, at);
    if (past != at && sql[at] != '-' && sql[at] != '/') {
      bare += sql.substr(at, past - at);
    } else if (past != at || is_blank(sql[at])) {
      if (!bare.empty() && bare.back() != ' ') bare += ' ';
    } else {
      bare += sql[at];
    }
    at = std::max(past, at + 1);
  }
  while (!bare.empty() && bare.back() == ' ') bare.pop_back();
  return bare;
}

/// The statements that made them, by "table NAME" and so on.
std::map<std::string, std::string> objects_of(Database& database) {
  std::map<std::string, std::string> objects;
  Statement statement(database,
                      "SELECT type || ' ' || name, sql FROM sqlite_schema WHERE sql NOT NULL "
                      "AND name NOT LIKE 'sqlite\\_%' ESCAPE '\\'");
  while (statement.step()) {
    std::string name;
    std::string sql;
    statement.read(name, sql);
    objects[name] = bare_statement(sql);
  }
  return objects;
}

/// A lab may look at its study in its own ways: a view or an index changes no row and refuses none.
bool restrains_nothing(std::string_view name, std::string_view sql) {
  return name.starts_with("view ") ||
         (name.starts_with("index ") && sql.find("UNIQUE") == sql.npos &&
          sql.find("unique") == sql.npos);
}

}  // namespace

std::vector<std::string> checks_in(std::string_view create_table) {
  std::vector<std::string> checks;
  for (std::size_t at = 0; at < create_table.size();) {
    if (const std::size_t past = past_quoted(create_table, at); past != at) {
      at = past;
    } else if (is_of_a_word(create_table[at])) {
      const std::size_t begin = at;
      while (at < create_table.size() && is_of_a_word(create_table[at])) ++at;
      if (!is_check(create_table.substr(begin, at - begin))) continue;
      const std::size_t open = create_table.find('(', at);
      if (open == std::string_view::npos) break;
      const std::size_t close = closing(create_table, open);
      checks.emplace_back(create_table.substr(open + 1, close - open - 1));
      at = std::min(close + 1, create_table.size());
    } else {
      ++at;
    }
  }
  return checks;
}

std::vector<std::string> broken_checks(Database& database) {
  std::vector<std::pair<std::string, std::string>> tables;
  {
    Statement statement(database,
                        "SELECT name, sql FROM sqlite_schema WHERE type = 'table' AND sql NOT NULL "
                        "ORDER BY rowid");
    while (statement.step()) {
      auto& [name, sql] = tables.emplace_back();
      statement.read(name, sql);
    }
  }
  std::vector<std::string> broken;
  for (const auto& [name, sql] : tables) {
    std::string columns;
    const std::vector<std::string> checks = checks_in(sql);
    if (checks.empty()) continue;
    // A CHECK that is NULL holds. A line break after each: it may end in a comment.
    for (const std::string& check : checks) {
      columns += (columns.empty() ? "" : ", ") + ("total(NOT (" + check) + "\n))";
    }
    std::string quoted = name;
    for (std::size_t at = 0; (at = quoted.find('"', at)) != std::string::npos; at += 2) {
      quoted.insert(at, 1, '"');
    }
    Statement statement(database, "SELECT " + columns + " FROM \"" + quoted + '"');
    if (!statement.step()) continue;
    std::vector<double> rows(checks.size());
    statement.read_all(rows);
    for (std::size_t i = 0; i < checks.size(); ++i) {
      if (rows[i] == 0.0) continue;
      broken.push_back(std::to_string(static_cast<std::int64_t>(rows[i])) +
                       (rows[i] == 1.0 ? " row of " : " rows of ") + name +
                       (rows[i] == 1.0 ? " violates" : " violate") + " the rule CHECK (" +
                       checks[i] + ')');
    }
  }
  return broken;
}

std::vector<std::string> changed_objects(Database& database, Database& made) {
  const std::map<std::string, std::string> has = objects_of(database);
  const std::map<std::string, std::string> should = objects_of(made);
  std::vector<std::string> changed;
  for (const auto& [name, sql] : should) {
    const auto found = has.find(name);
    if (found == has.end()) {
      changed.push_back("the " + name + ", which every study has, is missing");
    } else if (found->second != sql) {
      changed.push_back("the " + name +
                        " differs from the one that Asperity makes; it is now: " + found->second);
    }
  }
  for (const auto& [name, sql] : has) {
    if (should.contains(name) || restrains_nothing(name, sql)) continue;
    changed.push_back("the " + name + " was not made by Asperity: " + sql);
  }
  return changed;
}

}  // namespace asperity
