// Removes tests, questions, rows and findings whose analysis or test is that of women and men.

#include "app/report/text/report_sexes.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/findings/outcome/columns.h"
#include "app/findings/outcome/study_tests.h"

namespace asperity {

namespace {

constexpr std::string_view kSexes = kSexesTest;  // and kSexesEquivalence for their equivalence
constexpr std::string_view kEveryone = "Total";

bool is_of_one_sex(const Finding& finding) {
  constexpr std::string_view kPerson = "person=";
  const std::string key = finding.key.text();
  const std::size_t at = key.find(kPerson);
  return at != std::string::npos && key.substr(at + kPerson.size()) != kEveryone;
}

bool compares_sexes(const Finding& finding) {
  return finding.analysis.starts_with(kSexes) || finding.quantity.starts_with("group.") ||
         finding.key[0].starts_with("test=sexes") || is_of_one_sex(finding);
}

/// Keeps the rows of all participants in a table that has rows by sex; in other tables the column
/// names participants.
void keep_everyone(ResultTable& table) {
  const auto is_of_everyone = [&table](const ResultRow& row) {
    return RowReader(table, row).text(columns::kSex) == kEveryone;
  };
  if (std::none_of(table.rows.begin(), table.rows.end(), is_of_everyone)) return;
  std::erase_if(table.rows, [&](const auto& row) { return !is_of_everyone(row); });
}

void drop_test_of_sexes(ResultTable& tests) {
  std::erase_if(tests.rows, [&tests](const ResultRow& row) {
    return RowReader(tests, row).text(StudyTests::test_column()) == kSexes;
  });
}

}  // namespace

AnalysisOutcome without_sexes(AnalysisOutcome outcome) {
  std::erase_if(outcome.questions,
                [](const AnsweredQuestion& question) { return question.name.starts_with(kSexes); });
  std::erase_if(outcome.findings, compares_sexes);
  std::erase_if(outcome.test_sentences,
                [](const TestSentence& sentence) { return sentence.test == kSexes; });
  for (ResultTable& table : outcome.tables) {
    keep_everyone(table);
    if (table.name != StudyTests::kTable) continue;
    drop_test_of_sexes(table);
    table.note = outcome.note_of_tests_without_sexes;
  }
  return outcome;
}

}  // namespace asperity
