// Reads JSON, TSV, CSV, SPSS files and HTML into tables of text, and compares them.

#include "tests/earlier_studies/numbers.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>

#include <nlohmann/json.hpp>

#include "results_schema/tables/table.h"
#include "tests/app/sav_reading.h"
#include "tests/journeys/small_study.h"

namespace asperity::test {

namespace {

using Json = nlohmann::ordered_json;
using Row = std::vector<std::string>;

constexpr double kTolerance = 1e-9;
constexpr double kRounding = 1e-12;  // of numbers that are zero but for it
constexpr const char* kFindings = "findings";
constexpr const char* kReport = "rows of tables";

/// Without tabs and line breaks, which separate cells and rows where they are stored.
std::string in_one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(),
      [](char sign) { return sign == '\t' || sign == '\n' || sign == '\r'; }, ' ');
  return text;
}

std::vector<std::string> split(std::string_view text, char at) {
  std::vector<std::string> parts{};
  for (;;) {
    const std::size_t end = text.find(at);
    parts.emplace_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

std::vector<std::string> lines_of(std::string_view text) {
  if (text.ends_with('\n')) text.remove_suffix(1);
  return split(text, '\n');
}

std::optional<std::size_t> place_of(const std::vector<std::string>& columns,
                                    const std::string& name) {
  const auto found = std::find(columns.begin(), columns.end(), name);
  if (found == columns.end()) return {};
  return static_cast<std::size_t>(found - columns.begin());
}

// --- analyses ------------------------------------------------------------------------------------

std::string cell_of(const Json& value) {
  if (value.is_null()) return {};
  if (value.is_string()) return in_one_line(value.get<std::string>());
  return value.dump();
}

/// The members of an object, where it has them.
Row cells_of(const Json& object, const std::vector<std::string>& columns) {
  Row row{};
  for (const std::string& column : columns) {
    row.push_back(object.contains(column) ? cell_of(object.at(column)) : std::string());
  }
  return row;
}

NumberTable table_of(std::string name, std::vector<std::string> columns, const Json& rows) {
  NumberTable table{.name = std::move(name), .columns = std::move(columns)};
  for (const Json& row : rows) table.rows.push_back(cells_of(row, table.columns));
  return table;
}

// --- files of an export --------------------------------------------------------------------------

/// RFC 4180.
std::vector<Row> rows_of_csv(std::string_view text) {
  std::vector<Row> rows{};
  Row row{};
  std::string cell{};
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char sign = text[i];
    if (quoted) {
      if (sign != '"') {
        cell += sign;
      } else if (i + 1 < text.size() && text[i + 1] == '"') {
        cell += text[++i];
      } else {
        quoted = false;
      }
    } else if (sign == '"') {
      quoted = true;
    } else if (sign == ',' || sign == '\n') {
      row.push_back(in_one_line(std::exchange(cell, {})));
      if (sign == '\n') rows.push_back(std::exchange(row, {}));
    } else if (sign != '\r') {
      cell += sign;
    }
  }
  return rows;
}

std::vector<Row> rows_of_tsv(std::string_view text) {
  std::vector<Row> rows{};
  for (const std::string& line : lines_of(text)) rows.push_back(split(line, '\t'));
  return rows;
}

std::vector<Row> rows_of_sav(const fs::path& file) {
  const Sav read = sav(file);
  std::vector<Row> rows(1);
  for (const Sav::Variable& variable : read.variables) rows[0].push_back(variable.name);
  for (const auto& cells : read.rows) {
    Row row{};
    for (const Sav::Variable& variable : read.variables) {
      row.push_back(in_one_line(cells.at(variable.name)));
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

/// Columns with sentences of the program, which later versions may reword.
bool holds_words_of_the_program(const std::string& column) {
  return column == "invalid_reason" || column == "flag_reason";
}

NumberTable table_of_file(const fs::path& file, const std::string& name) {
  std::vector<Row> rows = file.extension() == ".sav"   ? rows_of_sav(file)
                          : file.extension() == ".csv" ? rows_of_csv(text_of(file))
                                                       : rows_of_tsv(text_of(file));
  if (rows.empty()) throw std::runtime_error(name + " has no columns");
  NumberTable table{.name = name, .columns = std::move(rows.front())};
  rows.erase(rows.begin());
  for (Row& row : rows) {
    if (row.size() != table.columns.size()) {
      throw std::runtime_error(name + ": a row of another length");
    }
    for (std::size_t i = 0; i < row.size(); ++i) {
      const bool is_missing = row[i] == "n/a" || (file.extension() == ".sav" && row[i] == ".");
      if (is_missing) row[i].clear();
      if (!row[i].empty() && holds_words_of_the_program(table.columns[i])) row[i] = "(words)";
    }
  }
  table.rows = std::move(rows);
  return table;
}

/// Files that describe the tables or repeat their cells.
bool is_left_out(const fs::path& file) {
  for (const char* name : {"codebook.tsv", "MANIFEST.tsv", "trials.sav"}) {
    if (file.filename() == name) return true;
  }
  return std::any_of(file.begin(), file.end(),
                     [](const fs::path& part) { return part == "bids" || part == "psychds"; });
}

// --- reports -------------------------------------------------------------------------------------

std::string_view between(std::string_view text, std::string_view begin, std::string_view end,
                         std::size_t& from) {
  const std::size_t at = text.find(begin, from);
  if (at == std::string_view::npos) {
    from = std::string_view::npos;
    return {};
  }
  const std::size_t first = at + begin.size();
  const std::size_t last = text.find(end, first);
  from = last == std::string_view::npos ? last : last + end.size();
  return text.substr(first, last == std::string_view::npos ? last : last - first);
}

/// With a hyphen as its minus.
std::string with_hyphens(std::string_view text) {
  constexpr std::string_view kMinus = "−";
  std::string made(text);
  for (std::size_t at = 0; (at = made.find(kMinus, at)) != std::string::npos;) {
    made.replace(at, kMinus.size(), "-");
  }
  return made;
}

/// "0.30 [0.05, 0.61]" → "0.30 0.05 0.61"; empty where there is none.
std::string numbers_in(std::string_view text) {
  const auto is_digit = [](char sign) { return sign >= '0' && sign <= '9'; };
  const std::string cell = with_hyphens(text);
  std::string numbers{};
  for (std::size_t i = 0; i < cell.size();) {
    const std::size_t digit = cell.find_first_not_of(cell[i] == '-' ? "-." : ".", i);
    const bool begins = digit - i <= 2 && digit < cell.size() && is_digit(cell[digit]);
    if (!begins) {
      ++i;
      continue;
    }
    if (!numbers.empty()) numbers += ' ';
    numbers += cell[i++];
    while (i < cell.size() && (is_digit(cell[i]) || cell[i] == '.' || cell[i] == 'e' ||
                               (cell[i - 1] == 'e' && (cell[i] == '-' || cell[i] == '+')))) {
      numbers += cell[i++];
    }
  }
  return numbers;
}

// --- comparing -----------------------------------------------------------------------------------

bool agree(const std::string& stored, const std::string& now) {
  if (stored == now) return true;
  const std::optional<double> a = number_in(stored);
  const std::optional<double> b = number_in(now);
  return a && b &&
         std::abs(*a - *b) <=
             std::max(kRounding, kTolerance * std::max(std::abs(*a), std::abs(*b)));
}

/// The place value of the last digit of a printed number, 0.01 of "0.30"; nothing for a whole number.
std::optional<double> last_place(const std::string& number) {
  const std::size_t exponent = std::min(number.find('e'), number.size());
  const std::size_t point = number.find('.');
  if (exponent == number.size() && point == std::string::npos) return {};
  const double power =
      number_in(number.substr(std::min(exponent + 1, number.size()))).value_or(0.0);
  const auto decimals = point < exponent ? static_cast<double>(exponent - point - 1) : 0.0;
  return std::pow(10.0, power - decimals);
}

/// Whether printed numbers are the same but for rounding: "0.0039" is "0.00388" with fewer digits.
bool agree_as_printed(const std::string& stored, const std::string& now) {
  if (agree(stored, now)) return true;
  const std::optional<double> a = last_place(stored);
  const std::optional<double> b = last_place(now);
  if (!a || !b) return false;
  const double place = std::max(*a, *b);
  return std::abs(*number_in(stored) - *number_in(now)) <= (0.5 + kTolerance) * place;
}

/// Whether all numbers of a row of a report are in another, in the same order, with more or fewer digits; ".33" is the number
/// "0.33".
bool holds_in_order(const std::string& now, const std::string& stored) {
  std::size_t found = 0;
  const std::vector<std::string> wanted = split(stored, ' ');
  for (const std::string& number : split(now, ' ')) {
    if (found < wanted.size() && agree_as_printed(wanted[found], number)) ++found;
  }
  return found == wanted.size();
}

/// Whether a number of the stored table had no interval: a later version may give it one.
bool lacks_interval(const NumberTable& stored, std::size_t row, std::size_t column) {
  const std::string& name = stored.columns[column];
  return stored.may_grow && stored.rows[row][column].empty() &&
         (name == "low" || name == "high" || name == "confidence");
}

/// Compares rows of two tables by the columns of the stored one.
class RowComparison final {
 public:
  RowComparison(const NumberTable& stored, const NumberTable& now) : stored_(stored), now_(now) {
    for (const std::string& column : stored.columns)
      places_.push_back(place_of(now.columns, column));
  }

  /// The columns in which they differ.
  std::vector<std::size_t> differences(std::size_t stored_row, std::size_t now_row) const {
    std::vector<std::size_t> columns{};
    for (std::size_t i = 0; i < places_.size(); ++i) {
      if (!places_[i]) continue;  // reported once, by missing_columns
      if (lacks_interval(stored_, stored_row, i)) continue;
      const std::string& then = stored_.rows[stored_row][i];
      const std::string& today = now_.rows[now_row][*places_[i]];
      const bool same = stored_.name == kReport ? holds_in_order(today, then) : agree(then, today);
      if (!same) columns.push_back(i);
    }
    return columns;
  }
  std::string sentence(std::size_t row, std::size_t column) const {
    return stored_.name + ", row " + std::to_string(row + 1) + ", " + stored_.columns[column] +
           ": " + stored_.rows[row][column] + " became " + now_.rows[row][*places_[column]];
  }
  std::vector<std::string> missing_columns() const {
    std::vector<std::string> missing{};
    for (std::size_t i = 0; i < places_.size(); ++i) {
      if (!places_[i]) missing.push_back(stored_.name + " has no column " + stored_.columns[i]);
    }
    return missing;
  }

 private:
  const NumberTable& stored_;
  const NumberTable& now_;
  std::vector<std::optional<std::size_t>> places_{};
};

void compare(const NumberTable& stored, const NumberTable& now, std::vector<std::string>& lacking) {
  const RowComparison comparison(stored, now);
  for (std::string& sentence : comparison.missing_columns()) lacking.push_back(std::move(sentence));
  if (!stored.may_grow) {
    if (stored.rows.size() != now.rows.size()) {
      lacking.push_back(stored.name + ": " + std::to_string(stored.rows.size()) + " rows became " +
                        std::to_string(now.rows.size()));
      return;
    }
    for (std::size_t row = 0; row < stored.rows.size(); ++row) {
      for (const std::size_t column : comparison.differences(row, row)) {
        lacking.push_back(comparison.sentence(row, column));
      }
    }
    return;
  }
  // Findings have names; the answers and the rows of a report are read one after the other.
  const bool is_ordered = !stored.name.ends_with(kFindings);
  std::vector<bool> taken(now.rows.size(), false);
  std::size_t at = 0;
  for (std::size_t row = 0; row < stored.rows.size(); ++row) {
    std::size_t found = at;
    while (found < now.rows.size() &&
           (taken[found] || !comparison.differences(row, found).empty())) {
      ++found;
    }
    if (found == now.rows.size()) {
      std::string cells{};
      for (const std::string& cell : stored.rows[row]) cells += (cells.empty() ? "" : ", ") + cell;
      lacking.push_back(stored.name + " lacks a row, or has it elsewhere: " + cells);
    } else {
      taken[found] = true;
      if (is_ordered) at = found + 1;
    }
  }
}

NumberTable* table_named(Numbers& numbers, const std::string& name) {
  const auto found = std::find_if(numbers.begin(), numbers.end(),
                                  [&](const NumberTable& table) { return table.name == name; });
  return found == numbers.end() ? nullptr : &*found;
}

}  // namespace

Numbers numbers_of_analysis(const std::string& json) {
  static const std::vector<std::string> kCounts{
      "kind",           "design",  "participants", "sessions",   "unfinished_sessions",
      "planned_trials", "answers", "flagged",      "not_counted"};
  static const std::vector<std::string> kFinding{
      "analysis", "quantity", "key", "value", "word", "unit", "low", "high", "confidence", "n"};
  static const std::vector<std::string> kQuestion{"question", "quantity", "key", "value",
                                                  "low",      "high",     "n"};
  Numbers numbers{};
  const Json outcomes = Json::parse(json).at("outcomes");
  for (const Json& outcome : outcomes) {
    const std::string name = cell_of(outcome.at("protocol")) + ' ' +
                             cell_of(outcome.at("protocol_version")) + ' ' +
                             cell_of(outcome.at("group"));
    numbers.push_back(table_of(name + ": counts", kCounts, Json::array({outcome})));
    for (const Json& table : outcome.at("tables")) {
      numbers.push_back(table_of(name + ": table " + cell_of(table.at("name")),
                                 table.at("columns").get<std::vector<std::string>>(),
                                 table.at("rows")));
    }
    numbers.push_back(table_of(name + ": " + kFindings, kFinding, outcome.at("findings")));
    numbers.back().may_grow = true;
    Json answers = Json::array();
    for (const Json& question : outcome.at("questions")) {
      answers.push_back(question.at("finding"));
      answers.back()["question"] = question.at("name");
    }
    numbers.push_back(table_of(name + ": questions", kQuestion, answers));
    numbers.back().may_grow = true;
  }
  return numbers;
}

Numbers numbers_of_export(const fs::path& folder) {
  std::set<std::string> names{};
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    const fs::path extension = entry.path().extension();
    if (extension != ".tsv" && extension != ".csv" && extension != ".sav") continue;
    const fs::path name = entry.path().lexically_relative(folder);
    if (!is_left_out(name)) names.insert(name);
  }
  Numbers numbers{};
  for (const std::string& name : names) numbers.push_back(table_of_file(folder / name, name));
  return numbers;
}

Numbers numbers_of_report(const std::string& html) {
  NumberTable table{.name = kReport, .columns = {"numbers"}, .rows = {}, .may_grow = true};
  for (std::size_t at = 0; at != std::string::npos;) {
    const std::string_view row = between(html, "<tr>", "</tr>", at);
    std::string numbers{};
    for (std::size_t in_row = 0; in_row != std::string::npos;) {
      const std::string found = numbers_in(between(row, "<td class=\"n\">", "</td>", in_row));
      if (!found.empty()) numbers += (numbers.empty() ? "" : " ") + found;
    }
    if (!numbers.empty()) table.rows.push_back({numbers});
  }
  return {table};
}

std::string text_of(const Numbers& numbers) {
  std::string text{};
  const auto add = [&text](const Row& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) text += (i == 0 ? "" : "\t") + cells[i];
    text += '\n';
  };
  for (const NumberTable& table : numbers) {
    text += (table.may_grow ? "##+ " : "## ") + table.name + '\n';
    add(table.columns);
    for (const Row& row : table.rows) add(row);
    text += '\n';
  }
  return text;
}

Numbers read_numbers(std::string_view text) {
  Numbers numbers{};
  const std::vector<std::string> lines = lines_of(text);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const bool may_grow = lines[i].starts_with("##+ ");
    if (!may_grow && !lines[i].starts_with("## ")) {
      throw std::runtime_error("no table begins in line " + std::to_string(i + 1));
    }
    NumberTable table{.name = lines[i].substr(may_grow ? 4 : 3),
                      .columns = split(lines.at(i + 1), '\t'),
                      .rows = {},
                      .may_grow = may_grow};
    for (i += 2; i < lines.size() && !lines[i].empty(); ++i) {
      table.rows.push_back(split(lines[i], '\t'));
      if (table.rows.back().size() != table.columns.size()) {
        throw std::runtime_error("a row of another length in line " + std::to_string(i + 1));
      }
    }
    numbers.push_back(std::move(table));
  }
  return numbers;
}

std::vector<Correction> read_corrections(std::string_view text) {
  std::vector<Correction> corrections{};
  for (const std::string& line : lines_of(text)) {
    if (line.empty() || line.starts_with('#')) continue;
    const std::vector<std::string> cells = split(line, '\t');
    const std::optional<double> row = cells.size() == 6 ? number_in(cells[1]) : std::nullopt;
    if (!row) throw std::runtime_error("not TABLE, ROW, COLUMN, WAS, IS, REASON: " + line);
    corrections.push_back(
        {cells[0], static_cast<int>(*row), cells[2], cells[3], cells[4], cells[5]});
  }
  return corrections;
}

void correct(Numbers& stored, const std::vector<Correction>& corrections) {
  for (const Correction& correction : corrections) {
    NumberTable* const table = table_named(stored, correction.table);
    const auto column =
        table == nullptr ? std::nullopt : place_of(table->columns, correction.column);
    const auto row = static_cast<std::size_t>(correction.row - 1);
    const bool is_there = column && correction.row > 0 && row < table->rows.size();
    if (!is_there || table->rows[row][*column] != correction.was) {
      throw std::runtime_error("nothing to correct: " + correction.table + ", row " +
                               std::to_string(correction.row) + ", " + correction.column + ": " +
                               correction.was);
    }
    table->rows[row][*column] = correction.is;
  }
  // Only now: corrections name rows as they are stored.
  for (NumberTable& table : stored) {
    if (table.name == kReport)
      std::erase_if(table.rows, [](const Row& row) { return row[0].empty(); });
  }
}

std::vector<std::string> differences(const Numbers& stored, const Numbers& now) {
  std::vector<std::string> lacking{};
  for (const NumberTable& table : stored) {
    const auto found = std::find_if(
        now.begin(), now.end(), [&](const NumberTable& each) { return each.name == table.name; });
    if (found == now.end()) {
      lacking.push_back("there is no table " + table.name);
    } else {
      compare(table, *found, lacking);
    }
  }
  return lacking;
}

}  // namespace asperity::test
