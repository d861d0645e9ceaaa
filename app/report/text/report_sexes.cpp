#include "app/report/text/report_sexes.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/findings/outcome/reading_table.h"
#include "app/findings/outcome/study_tests.h"

namespace asperity {

namespace {

constexpr std::string_view kSexes = kSexesTest;  // and kSexesEquivalence for their equivalence
constexpr std::string_view kEveryone = "Total";

bool is_of_one_sex(const Finding& finding) {
  constexpr std::string_view kPerson = "person=";
  const std::size_t at = finding.key.find(kPerson);
  return at != std::string::npos && finding.key.substr(at + kPerson.size()) != kEveryone;
}

bool compares_sexes(const Finding& finding) {
  return finding.analysis.starts_with(kSexes) || finding.quantity.starts_with("group.") ||
         finding.key.starts_with("test=sexes") || is_of_one_sex(finding);
}

/// Keeps the rows of all participants in a table that has rows by sex; in other tables the column
/// names participants.
void keep_everyone(Table& table) {
  const std::optional<std::size_t> person = column_of(table, "person");
  if (!person) return;
  const auto is_of_everyone = [&person](const std::vector<Cell>& row) {
    return row[*person] == Cell{std::string(kEveryone)};
  };
  if (std::none_of(table.rows.begin(), table.rows.end(), is_of_everyone)) return;
  std::erase_if(table.rows, [&](const auto& row) { return !is_of_everyone(row); });
}

void drop_test_of_sexes(Table& tests) {
  const std::size_t test = column_of(tests, "test").value();
  std::erase_if(tests.rows, [test](const std::vector<Cell>& row) {
    return row[test] == Cell{std::string(kSexes)};
  });
}

}  // namespace

AnalysisOutcome without_sexes(AnalysisOutcome outcome) {
  std::erase_if(outcome.questions,
                [](const AnsweredQuestion& question) { return question.name.starts_with(kSexes); });
  std::erase_if(outcome.findings, compares_sexes);
  std::erase_if(outcome.test_sentences,
                [](const TestSentence& sentence) { return sentence.test == kSexes; });
  for (NamedTable& named : outcome.tables) {
    keep_everyone(named.table);
    if (named.name != StudyTests::kTable) continue;
    drop_test_of_sexes(named.table);
    named.note = outcome.note_of_tests_without_sexes;
  }
  return outcome;
}

}  // namespace asperity
