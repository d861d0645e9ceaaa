// Findings of tables as a person reads them: keys down, quantities across.

#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "app/analyses/found_numbers.h"
#include "app/analyses/reading_number.h"
#include "app/cli/analysis_output.h"
#include "app/cli/terminal.h"

namespace asperity {
namespace {

constexpr std::size_t kTableWidth = 100;
constexpr std::size_t kMostRows = 200;  // of one table: nobody reads more
constexpr std::size_t kRowsOfLonger = 100;

/// Student's interval of a mean share stands as it stands everywhere: as far as a share can go. Uncut
/// it is a finding of its own, for programs that compare it.
std::string reading_value(const Finding& finding, const FoundNumbers& found) {
  const bool is_low = finding.quantity == "subj.ci.lower";
  if (is_low || finding.quantity == "subj.ci.upper") {
    const Finding* mean = found.find("subj.mean", finding.key);
    if (mean != nullptr && mean->low && mean->high) {
      return reading_number(is_low ? *mean->low : *mean->high);
    }
  }
  return finding.value ? reading_number(*finding.value) : finding.word;
}

/// A column: values by key, in the order in which the keys first stood.
struct Column {
  std::string name{};
  std::vector<std::string> keys{};
  std::vector<std::string> values{};
};

std::vector<Column> columns_of(std::span<const Finding> findings) {
  constexpr std::string_view kLower = ".lower";
  constexpr std::string_view kUpper = ".upper";
  const FoundNumbers found(findings);
  std::vector<Column> columns{};
  std::map<std::string, std::size_t> place{};
  for (const Finding& finding : findings) {
    std::string name = finding.quantity;
    const bool lower = name.ends_with(kLower);
    const bool upper = name.ends_with(kUpper);
    if (lower || upper) name.resize(name.size() - kLower.size());
    if (lower || upper) name += " interval";
    const auto [known, first] = place.emplace(name, columns.size());
    if (first) columns.push_back({name, {}, {}});
    Column& column = columns[known->second];
    if (upper && !column.keys.empty() && column.keys.back() == finding.key) {
      column.values.back() += ", " + reading_value(finding, found) + ']';
      continue;
    }
    column.keys.push_back(finding.key);
    column.values.push_back((lower ? "[" : "") + reading_value(finding, found));
  }
  return columns;
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
    text += "… and " + counted(rows - shown, "more row") + "; --json gives all of them\n";
  }
  return text;
}

std::size_t width_of(const Column& column) {
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

std::string reading_text_of(const TableFindings& findings) {
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
      if (keyed && !together.empty() && width + width_of(columns[i]) > kTableWidth) break;
      width += width_of(columns[i]);
      together.push_back(&columns[i]);
      printed[i] = true;
    }
    text += table_of(together, "key") + '\n';
  }
  std::set<std::string> said{};
  for (const Finding& finding : findings.findings) {
    if (finding.status == "ok") continue;
    const std::string sentence = finding.word + ": " + finding.status;
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
