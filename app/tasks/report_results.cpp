// The results of a chapter: whatever tables, figures and findings the analysis has, in its order.

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "app/analyses/reading_number.h"
#include "app/analyses/reading_table.h"
#include "app/tasks/report_sections.h"
#include "app/tasks/report_tests.h"

namespace asperity {

namespace {

constexpr const char* kTests = "tests";     // the table that has them all, where there is one
constexpr std::size_t kMostSentences = 16;  // more are read in a table
constexpr std::size_t kMostKeys = 6;        // of one refusal

std::string text_of_cell(const Cell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  if (const auto* whole = std::get_if<std::int64_t>(&cell)) return std::to_string(*whole);
  if (const auto* number = std::get_if<double>(&cell)) return reading_number(*number);
  return "–";
}

/// The same estimate and p can be told once.
using Told = std::set<std::pair<double, double>>;

/// Of a table of counted shares with intervals, the rows that are about everything, in words.
std::vector<std::string> answers_in(const Table& table, Told& told) {
  const auto share = column_of(table, "share");
  const auto of = column_of(table, "of");
  const auto low = column_of(table, "wilson_low");
  const auto chance = column_of(table, "chance");
  const auto p = column_of(table, "p");
  const auto persons = column_of(table, "persons");
  if (!share || !of || !low || *of == 0) return {};
  const std::size_t hits = *of - 1;  // what is counted; before it stand the keys
  struct Answer {
    std::vector<std::string> keys{};
    std::string text{};
    std::pair<double, double> numbers{};
  };
  std::vector<Answer> answers{};
  std::set<std::size_t> whole_places{};
  for (const std::vector<Cell>& row : table.rows) {
    const auto value = number_of(row[*share]);
    if (!value) continue;
    Answer& answer = answers.emplace_back();
    std::string key{};
    for (std::size_t i = 0; i < hits; ++i) {
      answer.keys.push_back(text_of_cell(row[i]));
      if (answer.keys.back() == "all" || answer.keys.back() == "Total") whole_places.insert(i);
      key += (key.empty() ? "" : " ") + table.columns[i] + '=' + answer.keys.back();
    }
    const std::string about = words_of_key(key);
    // Names stay as the study has them.
    answer.text = (about.starts_with("all ") ? capitalised(about) : about) + ": " +
                  text_of_cell(row[hits]) + ' ' + table.columns[hits] + " of " +
                  text_of_cell(row[*of]) + " (" + reading_percent(*value) + "; 95 % interval " +
                  reading_percent(number_of(row[*low]).value_or(0.0)) + " to " +
                  reading_percent(number_of(row[*low + 1]).value_or(1.0)) + ')';
    if (chance) {
      if (const auto by_chance = number_of(row[*chance])) {
        answer.text += ", where chance is " + reading_percent(*by_chance);
      }
    }
    if (p) {
      if (const auto value_of_p = number_of(row[*p])) {
        answer.text += "; " + reading_p(*value_of_p);
        answer.numbers = {*value, *value_of_p};
      }
    }
    if (persons) answer.text += " (n = " + text_of_cell(row[*persons]) + ')';
    answer.text += '.';
  }
  std::vector<std::string> sentences{};
  for (const Answer& answer : answers) {
    const bool is_part =
        std::any_of(whole_places.begin(), whole_places.end(), [&answer](std::size_t place) {
          return answer.keys[place] != "all" && answer.keys[place] != "Total";
        });
    if (is_part) continue;
    told.insert(answer.numbers);
    sentences.push_back(answer.text);
  }
  return sentences;
}

/// What stands in a column "p" of some table.
std::set<double> p_in_tables(const AnalysisOutcome& outcome) {
  std::set<double> found{};
  for (const NamedTable& named : outcome.tables) {
    for (std::size_t i = 0; i < named.table.columns.size(); ++i) {
      const std::string& name = named.table.columns[i];
      if (name != "p" && !name.ends_with("_p") && !name.starts_with("p_")) continue;
      for (const std::vector<Cell>& row : named.table.rows) {
        if (const auto p = number_of(row[i])) found.insert(*p);
      }
    }
  }
  return found;
}

std::vector<std::string> tests_in_words(const AnalysisOutcome& outcome, const Told& told,
                                        std::vector<ReportedTest>& rest) {
  const std::set<double> in_tables = p_in_tables(outcome);
  const bool has_questions = !outcome.questions.empty();
  // Where the analysis has gathered its tests, those of its parts are adjusted for other families.
  const bool are_gathered =
      std::any_of(outcome.tables.begin(), outcome.tables.end(),
                  [](const NamedTable& table) { return table.name == kTests; });
  std::vector<std::string> sentences{};
  for (const ReportedTest& test : tests_among(outcome.findings)) {
    if (!test.estimates.empty() &&
        told.contains({*test.estimates.front()->value, *test.p->value})) {
      continue;
    }
    // Questions have said what the answers come to, and rows of a table speak for themselves; what
    // is adjusted for its family, or about everything, is said besides.
    const bool is_in_table = in_tables.contains(*test.p->value);
    const bool is_said =
        are_gathered ? test.holm != nullptr && test.p->analysis == kTests
                     : test.holm != nullptr || (!has_questions && test.is_of_whole && !is_in_table);
    if (is_said && sentences.size() < kMostSentences) {
      sentences.push_back(sentence_of(test));
    } else if (!is_in_table) {
      rest.push_back(test);
    }
  }
  return sentences;
}

ReportTable tests_table(const std::vector<ReportedTest>& tests) {
  ReportTable table{};
  table.title = "Other tests";
  table.columns = {{"test", false}, {"of", false},  {"statistic", true},
                   {"p", true},     {"Holm", true}, {"n", true}};
  const auto p_text = [](const Finding* finding) {
    return finding == nullptr ? std::string("–") : reading_p(*finding->value).substr(2);
  };
  for (const ReportedTest& test : tests) {
    const std::string statistic = statistic_of(test);
    std::string p = p_text(test.p);
    if (p.starts_with("= ")) p = p.substr(2);
    std::string holm = p_text(test.holm);
    if (holm.starts_with("= ")) holm = holm.substr(2);
    table.rows.push_back(
        {test.p->method.empty() ? words_of_quantity(test.p->quantity) : test.p->method,
         words_of_key(test.p->key), statistic.empty() ? "–" : statistic, p, holm,
         reading_count(test.p->n)});
  }
  table.note = "Holm: p adjusted for all tests of its family.";
  return table;
}

std::string heading_of(const std::string& column) {
  const std::string no_break = "\u00A0";
  if (column == "sd") return "SD";
  if (column == "p_holm") return "p, Holm";
  if (column.starts_with("wilson")) return "Wilson 95" + no_break + "%";
  if (column.starts_with("clopper_pearson")) return "Clopper–Pearson 95" + no_break + "%";
  return words_of_quantity(column);
}

ReportTable table_of(const NamedTable& named) {
  const Table reading = reading_table(named.table);
  ReportTable table{};
  table.title = named.title.english();
  table.note = named.note.english();
  for (const std::string& column : reading.columns) {
    // Names and levels are text before they are shortened for reading; quantities are not.
    const auto at = column_of(named.table, column);
    const bool holds_words =
        at && std::any_of(named.table.rows.begin(), named.table.rows.end(),
                          [&at](const std::vector<Cell>& row) {
                            return std::holds_alternative<std::string>(row[*at]);
                          });
    const bool is_name = named.name == kConfusion && column != reading.columns.front();
    table.columns.push_back({is_name ? column : heading_of(column), !holds_words});
  }
  for (const std::vector<Cell>& row : reading.rows) {
    std::vector<std::string>& cells = table.rows.emplace_back();
    for (const Cell& cell : row) cells.push_back(text_of_cell(cell));
  }
  return table;
}

/// "share chosen of column 1, height_map"
std::string subject_of(const Finding& finding) {
  const std::string about = words_of_key(finding.key);
  return words_of_quantity(finding.quantity) + (about.empty() ? "" : " of " + about);
}

/// What the analysis could not answer, a sentence for each reason.
std::vector<std::string> refusals_in(const AnalysisOutcome& outcome) {
  std::vector<std::string> reasons{};
  std::map<std::string, std::vector<std::string>> subjects{};
  for (const Finding& finding : outcome.findings) {
    if (finding.status == "ok") continue;
    std::vector<std::string>& same = subjects[finding.status];
    if (same.empty()) reasons.push_back(finding.status);
    const std::string subject = subject_of(finding);
    if (same.empty() || same.back() != subject) same.push_back(subject);
  }
  std::vector<std::string> sentences{};
  for (const std::string& reason : reasons) {
    std::vector<std::string> same = subjects[reason];
    if (same.size() > kMostKeys + 1) {
      const std::size_t more = same.size() - kMostKeys;
      same.resize(kMostKeys);
      same.push_back(reading_count(more) + " more");
    }
    sentences.push_back(stopped(capitalised(listed(same)) + ": " + reason));
  }
  return sentences;
}

}  // namespace

ReportSection results_section(const AnalysisOutcome& outcome, std::span<const Figure> figures) {
  ReportSection section{"Results", {}};
  Told told{};
  for (const AnsweredQuestion& question : outcome.questions) {
    section.parts.emplace_back(
        ReportText{question.question.english() + ' ' + question.answer.as_sentence().english(),
                   ReportText::Tone::lead});
    if (!question.method.empty()) {
      section.parts.emplace_back(ReportText{question.method.as_sentence().english()});
    }
  }
  if (outcome.questions.empty()) {
    for (const NamedTable& named : outcome.tables) {
      const std::vector<std::string> answers = answers_in(named.table, told);
      if (answers.empty()) continue;
      for (const std::string& answer : answers) {
        section.parts.emplace_back(ReportText{answer, ReportText::Tone::lead});
      }
      break;  // the first table is the one that the experiment is about
    }
  }
  for (const Phrase& remark : outcome.remarks) {
    section.parts.emplace_back(ReportText{remark.english(), ReportText::Tone::notice});
  }
  std::vector<ReportedTest> rest{};
  std::vector<std::string> sentences = tests_in_words(outcome, told, rest);
  if (!sentences.empty()) section.parts.emplace_back(ReportList{std::move(sentences)});
  bool has_tests = false;
  const auto belongs_to = [&outcome](const Figure& figure, const NamedTable* table) {
    if (table != nullptr) return figure.table == table->name;
    return std::none_of(outcome.tables.begin(), outcome.tables.end(),
                        [&figure](const NamedTable& each) { return each.name == figure.table; });
  };
  const auto add_figures_of = [&](const NamedTable* table) {
    for (const Figure& figure : figures) {
      if (belongs_to(figure, table)) section.parts.emplace_back(ReportFigure{0, figure});
    }
  };
  add_figures_of(nullptr);
  for (const NamedTable& named : outcome.tables) {
    add_figures_of(&named);
    section.parts.emplace_back(table_of(named));
    if (named.name == kTests) has_tests = true;
  }
  if (!rest.empty() && !has_tests) section.parts.emplace_back(tests_table(rest));
  std::vector<std::string> refusals = refusals_in(outcome);
  if (!refusals.empty()) {
    section.parts.emplace_back(ReportText{"What could not be answered, and why:"});
    section.parts.emplace_back(ReportList{std::move(refusals)});
  }
  return section;
}

ReportSection numbers_section(const AnalysisOutcome& outcome) {
  ReportSection section{"Every number of the analysis", {}};
  if (outcome.findings.empty()) {
    section.parts.emplace_back(ReportText{"The analysis has come to no numbers."});
    return section;
  }
  ReportTable table{};
  table.is_reference = true;
  table.title = "Findings, as asperity analyze --json has them with all digits";
  table.columns = {{"quantity", false}, {"of", false}, {"value", true},
                   {"interval", true},  {"n", true},   {"how", true}};
  const bool has_parts =
      std::any_of(outcome.findings.begin(), outcome.findings.end(),
                  [](const Finding& finding) { return !finding.analysis.empty(); });
  if (has_parts) table.columns.insert(table.columns.begin(), {"analysis", false});
  std::vector<std::string> ways{};
  for (const Finding& finding : outcome.findings) {
    const std::string way = finding.status == "ok" ? finding.method : finding.status;
    std::string number = "–";
    if (!way.empty()) {
      auto found = std::find(ways.begin(), ways.end(), way);
      if (found == ways.end()) found = ways.insert(ways.end(), way);
      number = std::to_string(found - ways.begin() + 1);
    }
    std::string value = finding.word.empty() ? "–" : finding.word;
    if (finding.value) {
      value = reading_number(*finding.value);
      if (!finding.unit.empty() && finding.unit != "1") value += ' ' + finding.unit;
    }
    const std::string interval =
        finding.low && finding.high
            ? '[' + reading_number(*finding.low) + ", " + reading_number(*finding.high) + ']'
            : "–";
    table.rows.push_back({words_of_quantity(finding.quantity), words_of_key(finding.key), value,
                          interval, reading_count(finding.n), number});
    if (has_parts) {
      std::vector<std::string>& cells = table.rows.back();
      cells.insert(cells.begin(), words_of_quantity(finding.analysis));
    }
  }
  for (std::size_t i = 0; i < ways.size(); ++i) {
    table.note += (i == 0 ? "How: (" : " (") + std::to_string(i + 1) + ") " + ways[i] +
                  (ways[i].ends_with('.') ? "" : ".");
  }
  section.parts.emplace_back(std::move(table));
  return section;
}

}  // namespace asperity
