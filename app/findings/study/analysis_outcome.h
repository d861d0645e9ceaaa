// What the analysis of a protocol's answers comes to: tables, findings and remarks.

#pragma once

#include <compare>
#include <set>
#include <string>
#include <vector>

#include "analysis/finding.h"
#include "app/findings/study/gathered_answers.h"
#include "app/words/phrase.h"
#include "results_schema/table.h"

namespace asperity {

/// The table of what was felt and what was chosen: its columns are named by the study's pictures.
inline constexpr const char* kConfusion = "confusion";

/// The findings and the table of estimates by spacing and condition.
inline constexpr const char* kRoughness = "roughness";
/// The table of each participant's estimates in every cell: person, condition, spacing, answers, raw and
/// normalised.
inline constexpr const char* kEstimatesOfPersons = "estimates";

/// A table for people and programs: column names are fixed words with units, numbers have all their
/// digits, missing is missing. Where `x_low` and `x_high` stand, they are one interval.
struct NamedTable {
  std::string name{};  ///< fixed, for programs: "table_1", "shares"
  Phrase title{};      ///< for people
  Table table{};
  Phrase note{};  ///< how to read it, chance included; may be empty
};

/// A question that a kind of protocol asks, in words, and what the answers of people say to it.
struct AnsweredQuestion {
  std::string name{};   ///< fixed, for programs: "preference"
  Phrase question{};    ///< "Is one rendering chosen more often than the others?"
  Phrase answer{};      ///< one sentence with its interval, or why there is none
  Phrase method{};      ///< what was computed, to be folded away
  std::string table{};  ///< the name of the table that says more
  Finding finding{};    ///< the number in the answer; its status says why there is none
  Phrase counted{};     ///< what its n counts: "20 participants"; empty where there is none
};

struct TestMethod;

/// The test of women and men; see KindTest.
inline constexpr const char* kSexesTest = "sexes";

/// What was specified of a test in advance.
enum class TestRole {
  confirmatory,  ///< of the family that the protocol declares
  usual_family,  ///< of the family that is usual for its kind of protocol, which declares none
  exploratory,
};

/// What a test found, in English, as a paper prints it.
struct TestSentence {
  std::string test{};  ///< the name of a KindTest
  TestRole role = TestRole::exploratory;
  bool is_untested = false;
  bool has_mean_interval = false;  ///< the CI of a mean proportion
  bool has_effect = false;
  const TestMethod* made_by = nullptr;  ///< null where it could not be made
  std::string text{};
};

/// What tells a finding of an outcome from its others.
struct FindingName {
  std::string analysis{};
  std::string quantity{};
  std::string key{};

  auto operator<=>(const FindingName&) const = default;
};
inline FindingName name_of(const Finding& finding) {
  return {finding.analysis, finding.quantity, finding.key};
}

/// Whether the protocol declares a family of tests before data collection.
enum class FamilyDeclaration { none, declared, differs_between_files };

/// The answers of one group to one version of one protocol, analysed.
struct AnalysisOutcome {
  std::string protocol{};
  std::string version{};
  std::string kind{};
  std::string design{};
  AnswerGroup group = AnswerGroup::people;
  AnswerCount count{};
  FamilyDeclaration family = FamilyDeclaration::none;
  bool declares_sexes = false;                ///< the protocol's family compares women and men
  std::size_t answers = 0;                    ///< attempts that the tables count
  std::vector<AnsweredQuestion> questions{};  ///< the one that the study is about first
  std::vector<NamedTable> tables{};
  std::vector<Finding> findings{};
  std::set<FindingName> tests_in_tables{};  ///< whose p stands in a table: told there
  std::vector<TestSentence> test_sentences{};  ///< in the order of the table of tests
  Phrase
      note_of_tests_without_sexes{};  ///< of that table, where the test of women and men is left out
  std::vector<Phrase> remarks{};  ///< sentences, each to be read before believing a number
};

}  // namespace asperity
