// Numbers are shortened here and nowhere before.

#include "app/cli/output/analysis_output.h"

#include <optional>
#include <variant>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/cli/output/terminal.h"
#include "app/findings/outcome/displayed_table.h"
#include "app/words/text_parts.h"

namespace asperity {

namespace {

using Json = nlohmann::ordered_json;

/// Lines no longer than a terminal is wide; `prefix` before the first, as much room before others.
std::string paragraph(const std::string& prefix, const std::string& text) {
  return wrapped_text(text, kTerminalColumns, prefix) + '\n';
}

/// The table as a terminal prints it: quantities at the right, words at the left.
std::string terminal_text(const ResultTable& table) {
  const DisplayedTable shown = displayed(table, Reader::terminal);
  Table made{};
  std::vector<bool> numeric{};
  for (const DisplayedColumn& column : shown.columns) {
    made.columns.push_back(column.heading.english());
    numeric.push_back(!column.holds_words);
  }
  for (const std::vector<Phrase>& row : shown.rows) {
    std::vector<Cell>& cells = made.rows.emplace_back();
    for (const Phrase& cell : row) cells.push_back(cell.empty() ? Cell{} : Cell{cell.english()});
  }
  return aligned(made, numeric);
}

Json json_of(const Cell& cell) {
  if (const auto* number = std::get_if<double>(&cell)) return *number;
  if (const auto* whole = std::get_if<std::int64_t>(&cell)) return *whole;
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  return nullptr;
}

Json json_of(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json json_of(const ResultTable& result) {
  const Table table = stored_table(result);
  Json rows = Json::array();
  for (const std::vector<Cell>& cells : table.rows) {
    Json row = Json::object();
    for (std::size_t i = 0; i < cells.size(); ++i) row[table.columns[i]] = json_of(cells[i]);
    rows.push_back(std::move(row));
  }
  return {{"name", result.name},
          {"title", result.title.english()},
          {"note", result.note.english()},
          {"columns", table.columns},
          {"rows", std::move(rows)}};
}

Json json_of(const Finding& finding) {
  return {{"quantity", finding.quantity},
          {"key", finding.key.text()},
          {"value", json_of(finding.value)},
          {"word", finding.word.empty() ? Json(nullptr) : Json(finding.word)},
          {"unit", finding.unit},
          {"low", json_of(finding.low)},
          {"high", json_of(finding.high)},
          {"confidence", json_of(finding.confidence)},
          {"method", finding.method},
          {"status", finding.status},
          {"n", finding.n}};
}

/// One of several analyses that stand together.
Json json_of_part(const Finding& finding) {
  Json json = json_of(finding);
  json["analysis"] = finding.analysis;
  return json;
}

Json json_of(const AnsweredQuestion& question) {
  return {{"name", question.name},
          {"question", question.question.english()},
          {"answer", question.answer.english()},
          {"method", question.method.english()},
          {"table", question.table},
          {"finding", json_of_part(question.finding)}};
}

Json json_of(const AnalysisOutcome& outcome) {
  Json remarks = Json::array();
  for (const Phrase& remark : outcome.remarks) remarks.push_back(remark.english());
  Json tables = Json::array();
  for (const ResultTable& table : outcome.tables) tables.push_back(json_of(table));
  Json findings = Json::array();
  for (const Finding& finding : outcome.findings) findings.push_back(json_of_part(finding));
  Json questions = Json::array();
  for (const AnsweredQuestion& question : outcome.questions) questions.push_back(json_of(question));
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
          {"remarks", std::move(remarks)},
          {"questions", std::move(questions)},
          {"tables", std::move(tables)},
          {"findings", std::move(findings)}};
}

}  // namespace

std::string display_text_of(const AnalysisOutcome& outcome) {
  std::string heading = outcome.protocol + ' ' + outcome.version + " (" + outcome.kind + ", " +
                        outcome.design + "): " + text_of(outcome.group);
  std::string text = heading + '\n' + std::string(heading.size(), '=') + '\n';
  text += counted(outcome.count.participants, "participant") + ", " +
          counted(outcome.count.sessions, "session") + ", " +
          counted(outcome.count.planned_trials, "planned trial") + " of the main phase, " +
          counted(outcome.answers, "response") + " counted\n";
  for (const Phrase& remark : outcome.remarks) text += paragraph("! ", remark.english());
  for (const AnsweredQuestion& question : outcome.questions) {
    text += '\n' + paragraph("", question.question.english());
    text += paragraph("  ", question.answer.english());
  }
  for (const ResultTable& table : outcome.tables) {
    // In --json and in the exports.
    if (table.lists_trials && outcome.tables.size() > 1) continue;
    const std::string title = table.title.english();
    text += '\n' + title + '\n' + std::string(title.size(), '-') + '\n';
    text += terminal_text(table);
    if (!table.note.empty()) text += paragraph("  ", table.note.english());
  }
  return text;
}

std::string analysis_json(const std::string& study, std::span<const AnalysisOutcome> outcomes) {
  Json json{{"format", "asperity.analysis/1"}, {"study", study}, {"outcomes", Json::array()}};
  for (const AnalysisOutcome& outcome : outcomes) json["outcomes"].push_back(json_of(outcome));
  return json.dump(2) + '\n';
}

std::string findings_json(const TableFindings& findings) {
  Json json{{"format", "asperity.findings/1"},
            {"kind", findings.kind},
            {"files", findings.files},
            {"findings", Json::array()}};
  for (const Finding& finding : findings.findings) json["findings"].push_back(json_of(finding));
  return json.dump(2) + '\n';
}

}  // namespace asperity
