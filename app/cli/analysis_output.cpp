// Numbers are shortened here and nowhere before.

#include "app/cli/analysis_output.h"

#include <array>
#include <charconv>
#include <optional>
#include <string_view>
#include <variant>

#include <nlohmann/json.hpp>

#include "app/cli/terminal.h"

namespace asperity {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kLow = "_low";
constexpr std::string_view kHigh = "_high";
constexpr std::size_t kLineWidth = 100;

/// 2.5e-23
std::string scientific(double value) {
  std::array<char, 32> text{};
  const auto result = std::to_chars(text.data(), text.data() + text.size(), value,
                                    std::chars_format::scientific, 1);
  return {text.data(), result.ptr};
}

/// A share to two decimals, a force to a millinewton, a p to three decimals or in powers of ten.
std::string reading_number(const std::string& column, double value) {
  if (column == "p") return value < 0.001 ? scientific(value) : fixed(value, 3);
  if (column == "chance" || column.ends_with("_N")) return fixed(value, 3);
  return fixed(value, 2);
}

std::string reading_cell(const std::string& column, const Cell& cell) {
  if (const auto* number = std::get_if<double>(&cell)) return reading_number(column, *number);
  if (const auto* whole = std::get_if<std::int64_t>(&cell)) return std::to_string(*whole);
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  return "n/a";
}

/// The same table with `x_low` and `x_high` as one column x: "[0.36, 0.81]".
Table reading_table(const Table& table) {
  Table reading{};
  std::vector<std::size_t> lows{};
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const std::string& name = table.columns[i];
    if (name.ends_with(kHigh)) continue;
    reading.columns.push_back(
        name.ends_with(kLow) ? name.substr(0, name.size() - kLow.size()) + " 95 %" : name);
  }
  for (const std::vector<Cell>& row : table.rows) {
    std::vector<Cell>& cells = reading.rows.emplace_back();
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string& name = table.columns[i];
      if (name.ends_with(kHigh)) continue;
      const bool is_interval = name.ends_with(kLow) && i + 1 < row.size();
      if (std::holds_alternative<std::monostate>(row[i])) {
        cells.emplace_back();
      } else if (is_interval) {
        cells.emplace_back('[' + reading_cell(name, row[i]) + ", " +
                           reading_cell(name, row[i + 1]) + ']');
      } else if (std::holds_alternative<double>(row[i])) {
        cells.emplace_back(reading_cell(name, row[i]));
      } else {
        cells.push_back(row[i]);
      }
    }
  }
  return reading;
}

/// Lines no longer than a terminal is wide; `prefix` before the first, as much room before others.
std::string wrapped(const std::string& prefix, std::string_view text) {
  std::string out = prefix;
  std::size_t used = prefix.size();
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (used + word.size() > kLineWidth && used > prefix.size()) {
      out += '\n' + std::string(prefix.size(), ' ');
      used = prefix.size();
    }
    out += word;
    used += word.size() + 1;
    if (!text.empty()) out += ' ';
  }
  // No line ends in a blank.
  std::string tidy{};
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (out[i] == ' ' && i + 1 < out.size() && out[i + 1] == '\n') continue;
    tidy += out[i];
  }
  return tidy + '\n';
}

std::string plural(std::size_t count, const std::string& word) {
  return std::to_string(count) + ' ' + word + (count == 1 ? "" : "s");
}

Json json_of(const Cell& cell) {
  if (const auto* number = std::get_if<double>(&cell)) return *number;
  if (const auto* whole = std::get_if<std::int64_t>(&cell)) return *whole;
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  return nullptr;
}

Json json_of(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json json_of(const NamedTable& table) {
  Json rows = Json::array();
  for (const std::vector<Cell>& cells : table.table.rows) {
    Json row = Json::object();
    for (std::size_t i = 0; i < cells.size(); ++i) row[table.table.columns[i]] = json_of(cells[i]);
    rows.push_back(std::move(row));
  }
  return {{"name", table.name},
          {"title", table.title},
          {"note", table.note},
          {"columns", table.table.columns},
          {"rows", std::move(rows)}};
}

Json json_of(const Finding& finding) {
  return {{"quantity", finding.quantity},
          {"key", finding.key},
          {"value", json_of(finding.value)},
          {"unit", finding.unit},
          {"low", json_of(finding.low)},
          {"high", json_of(finding.high)},
          {"confidence", json_of(finding.confidence)},
          {"method", finding.method},
          {"status", finding.status},
          {"n", finding.n}};
}

Json json_of(const AnalysisOutcome& outcome) {
  Json tables = Json::array();
  for (const NamedTable& table : outcome.tables) tables.push_back(json_of(table));
  Json findings = Json::array();
  for (const Finding& finding : outcome.findings) findings.push_back(json_of(finding));
  return {{"protocol", outcome.protocol},
          {"protocol_version", outcome.version},
          {"kind", outcome.kind},
          {"design", outcome.design},
          {"group", text_of(outcome.group)},
          {"participants", outcome.count.participants},
          {"sessions", outcome.count.sessions},
          {"unfinished_sessions", outcome.count.unfinished_sessions},
          {"planned_trials", outcome.count.planned_trials},
          {"answers", outcome.answers},
          {"flagged", outcome.count.flagged},
          {"not_counted", outcome.count.not_counted},
          {"remarks", outcome.remarks},
          {"tables", std::move(tables)},
          {"findings", std::move(findings)}};
}

}  // namespace

std::string reading_text_of(const AnalysisOutcome& outcome) {
  std::string heading = outcome.protocol + ' ' + outcome.version + " (" + outcome.kind + ", " +
                        outcome.design + "): " + text_of(outcome.group);
  std::string text = heading + '\n' + std::string(heading.size(), '=') + '\n';
  text += plural(outcome.count.participants, "participant") + ", " +
          plural(outcome.count.sessions, "session") + ", " +
          plural(outcome.count.planned_trials, "planned trial") + " of the main phase, " +
          plural(outcome.answers, "answer") + " counted\n";
  for (const std::string& remark : outcome.remarks) text += wrapped("! ", remark);
  for (const NamedTable& table : outcome.tables) {
    text += '\n' + table.title + '\n' + std::string(table.title.size(), '-') + '\n';
    text += aligned(reading_table(table.table));
    if (!table.note.empty()) text += wrapped("  ", table.note);
  }
  return text;
}

std::string analysis_json(const std::string& study, std::span<const AnalysisOutcome> outcomes) {
  Json json{{"format", "asperity.analysis/1"}, {"study", study}, {"outcomes", Json::array()}};
  for (const AnalysisOutcome& outcome : outcomes) json["outcomes"].push_back(json_of(outcome));
  return json.dump(2) + '\n';
}

}  // namespace asperity
