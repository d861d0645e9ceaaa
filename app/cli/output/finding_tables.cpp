// Findings of tables as a person reads them: keys down, quantities across.

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "app/cli/output/analysis_output.h"
#include "app/cli/output/terminal.h"
#include "app/findings/outcome/display_number.h"
#include "app/findings/outcome/found_numbers.h"

namespace asperity {
namespace {

constexpr std::size_t kTableWidth = 100;
constexpr std::size_t kMostRows = 200;  // of one table: nobody reads more
constexpr std::size_t kRowsOfLonger = 100;
constexpr const char* kInterval = " interval";

/// Student's interval of a mean proportion is shown as far as a proportion can go; programs that compare it have it
/// uncut.
std::string display_value(const Finding& finding) {
  const bool is_of_share = is(finding, "subj.ci.lower") || is(finding, "subj.ci.upper");
  if (is_of_share && finding.value) return display_number(std::clamp(*finding.value, 0.0, 1.0));
  return finding.value ? display_number(*finding.value) : finding.word;
}

/// A column: values by key, in the order in which the keys first stood.
struct Column {
  std::string name{};
  std::vector<std::string> keys{};
  std::vector<std::string> values{};
  std::vector<std::string> intervals{};  ///< of the values themselves; empty where there is none
};

/// "peak.delta.lower" is the lower end of "peak.delta interval", "ci.upper.wide" the upper one of
/// "ci.wide interval".
struct EndOfInterval {
  bool is_lower = false;
  std::string interval{};
};

std::optional<EndOfInterval> end_in(const std::string& quantity) {
  for (const std::string_view part : {".lower", ".upper"}) {
    const std::size_t at = quantity.rfind(part);
    if (at == std::string::npos) continue;
    const std::size_t end = at + part.size();
    if (end < quantity.size() && quantity[end] != '.') continue;
    return EndOfInterval{.is_lower = part == ".lower",
                         .interval = quantity.substr(0, at) + quantity.substr(end) + kInterval};
  }
  return std::nullopt;
}

/// The intervals of which both ends are findings: the least possible of a number is no interval.
std::set<std::string> whole_intervals(std::span<const Finding> findings) {
  std::map<std::string, std::set<bool>> ends{};
  for (const Finding& finding : findings) {
    if (const auto end = end_in(finding.quantity)) ends[end->interval].insert(end->is_lower);
  }
  std::set<std::string> whole{};
  for (const auto& [interval, own] : ends) {
    if (own.size() == 2) whole.insert(interval);
  }
  return whole;
}

std::string display_end(double end) {
  if (std::isnan(end)) return "NA";
  if (std::isinf(end)) return end > 0.0 ? "Inf" : "-Inf";
  return display_number(end);
}

std::string interval_of(const Finding& finding) {
  if (!finding.low || !finding.high) return {};
  return '[' + display_end(*finding.low) + ", " + display_end(*finding.high) + ']';
}

/// Whether a column of intervals says what the intervals of `column` say.
bool is_said_by(const Column& other, const Column& column) {
  std::map<std::string_view, std::string_view> said{};
  for (std::size_t i = 0; i < other.keys.size(); ++i) said[other.keys[i]] = other.values[i];
  for (std::size_t i = 0; i < column.keys.size(); ++i) {
    if (column.intervals[i].empty()) continue;
    const auto same = said.find(column.keys[i]);
    if (same == said.end() || same->second != column.intervals[i]) return false;
  }
  return true;
}

/// Each number's own interval beside it, where none of the columns says it.
std::vector<Column> with_intervals(const std::vector<Column>& columns) {
  std::vector<Column> all{};
  for (const Column& column : columns) {
    all.push_back(column);
    const bool has_some = std::any_of(column.intervals.begin(), column.intervals.end(),
                                      [](const std::string& one) { return !one.empty(); });
    if (!has_some) continue;
    const bool is_said = std::any_of(columns.begin(), columns.end(), [&](const Column& other) {
      return other.name.ends_with(kInterval) && is_said_by(other, column);
    });
    if (is_said) continue;
    Column own{.name = column.name + kInterval, .keys = column.keys, .values = column.intervals};
    std::replace(own.values.begin(), own.values.end(), std::string(), std::string("–"));
    all.push_back(std::move(own));
  }
  return all;
}

std::vector<Column> columns_of(std::span<const Finding> findings) {
  const FoundNumbers found(findings);
  const std::set<std::string> whole = whole_intervals(findings);
  std::vector<Column> columns{};
  std::map<std::string, std::size_t> place{};
  for (const Finding& finding : findings) {
    const auto end = end_in(finding.quantity);
    const bool is_end = end && whole.contains(end->interval);
    const std::string& name = is_end ? end->interval : finding.quantity;
    const auto [known, first] = place.emplace(name, columns.size());
    if (first) columns.push_back({.name = name});
    Column& column = columns[known->second];
    const std::string value = display_value(finding);
    if (is_end && !end->is_lower && !column.keys.empty() &&
        column.keys.back() == finding.key.text()) {
      column.values.back() += ", " + value + ']';
      continue;
    }
    column.keys.push_back(finding.key.text());
    column.values.push_back((is_end ? "[" : "") + value);
    column.intervals.push_back(is_end ? "" : interval_of(finding));
  }
  return with_intervals(columns);
}

std::string table_of(std::span<const Column* const> columns, const std::string& key_name) {
  Table table{};
  const bool keyed = columns.front()->keys != std::vector<std::string>{""};
  if (!keyed) {
    table.columns = {"quantity", "value"};
    for (const Column* column : columns) {
      table.rows.push_back({column->name, column->values.front()});
    }
    return aligned(table);
  }
  table.columns.push_back(key_name);
  for (const Column* column : columns) table.columns.push_back(column->name);
  const std::size_t rows = columns.front()->keys.size();
  const std::size_t shown = rows > kMostRows ? kRowsOfLonger : rows;
  for (std::size_t row = 0; row < shown; ++row) {
    std::vector<Cell>& cells = table.rows.emplace_back();
    cells.emplace_back(columns.front()->keys[row]);
    for (const Column* column : columns) cells.emplace_back(column->values[row]);
  }
  std::string text = aligned(table);
  if (shown < rows) {
    text += "… and " + counted(rows - shown, "more row") + "; --json prints all rows\n";
  }
  return text;
}

std::size_t column_width(const Column& column) {
  std::size_t width = column.name.size();
  for (const std::string& value : column.values) width = std::max(width, value.size());
  return width + 2;
}

std::size_t key_width_of(const Column& column) {
  std::size_t width = 0;
  for (const std::string& key : column.keys) width = std::max(width, key.size());
  return width;
}

}  // namespace

std::string display_text_of(const TableFindings& findings) {
  std::string text = findings.kind + ":";
  for (const std::string& file : findings.files) text += ' ' + file;
  text += "\n\n";
  const std::vector<Column> columns = columns_of(findings.findings);
  // Quantities with the same keys share a table, as many as a line holds.
  std::vector<bool> printed(columns.size(), false);
  for (std::size_t first = 0; first < columns.size(); ++first) {
    if (printed[first]) continue;
    std::vector<const Column*> together{};
    std::size_t width = key_width_of(columns[first]);
    const bool keyed = columns[first].keys != std::vector<std::string>{""};
    for (std::size_t i = first; i < columns.size(); ++i) {
      if (printed[i] || columns[i].keys != columns[first].keys) continue;
      if (keyed && !together.empty() && width + column_width(columns[i]) > kTableWidth) break;
      width += column_width(columns[i]);
      together.push_back(&columns[i]);
      printed[i] = true;
    }
    text += table_of(together, "key") + '\n';
  }
  std::set<std::string> said{};
  for (const Finding& finding : findings.findings) {
    if (finding.status == "ok") continue;
    // An empty word is that of an empty result, which the number with its key names.
    const std::string name =
        finding.quantity + (finding.key.empty() ? "" : ' ' + finding.key.text());
    const std::string sentence =
        (finding.word.empty() ? name : finding.word) + ": " + finding.status;
    if (said.insert(sentence).second) text += "! " + sentence + '\n';
  }
  std::vector<std::string> methods{};
  std::map<std::string, std::vector<std::string>> quantities{};
  for (const Finding& finding : findings.findings) {
    if (finding.method.empty()) continue;
    std::vector<std::string>& same = quantities[finding.method];
    if (same.empty()) methods.push_back(finding.method);
    if (std::find(same.begin(), same.end(), finding.quantity) == same.end()) {
      same.push_back(finding.quantity);
    }
  }
  for (const std::string& method : methods) {
    std::string names{};
    for (const std::string& name : quantities[method]) names += (names.empty() ? "" : ", ") + name;
    text += names + ": " + method + '\n';
  }
  return text;
}

}  // namespace asperity
