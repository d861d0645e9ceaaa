// Stores the result of the analysis of a protocol's responses: tables, findings and remarks.

#pragma once

#include <compare>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "analysis/numbers/finding.h"
#include "analysis/words/phrase.h"
#include "app/findings/gathering/gathered_answers.h"
#include "app/findings/outcome/result_table.h"
#include "protocols/design/analysis_declaration.h"

namespace asperity {

/// The findings and the table of estimates by spacing and condition.
inline constexpr const char* kRoughness = "roughness";
/// The same by stimulus, where stimuli are not compared by their spacings.
inline constexpr const char* kStimulusEstimates = "stimulus_estimates";
/// The table of each participant's estimates in every cell: participant, condition, spacing,
/// responses, raw and normalised.
inline constexpr const char* kEstimatesOfPersons = "estimates";

/// A question of a kind of protocol, as text, and the answer that the participants' responses give.
struct AnsweredQuestion {
  std::string name{};   ///< fixed, for programs: "preference"
  Phrase question{};    ///< "Is one rendering chosen more often than the others?"
  Phrase answer{};      ///< one sentence with its interval, or why there is no answer
  Phrase method{};      ///< what was computed; collapsed by default
  std::string table{};  ///< the name of the table with the details
  Finding finding{};    ///< the number in the answer; its status states why there is none
  Phrase counted{};     ///< the unit of its n: "20 participants"; empty where there is none
};

struct TestMethod;

/// The comparison of women and men; see KindTest.
inline constexpr const char* kSexesTest = "sexes";

/// The role of a test as specified in advance.
enum class TestRole {
  confirmatory,  ///< of the family that the protocol declares
  /// Of the default family of its kind of protocol, where the protocol declares none.
  usual_family,
  exploratory,
};

/// Which of several comparisons of one name a test makes: that of a scale, condition, texture or property, that of two items, that
/// of two items on a scale, or that of correct and incorrect responses by a scale and its question; empty for the only one.
struct TestSubject {
  TestSubject() = default;
  TestSubject(std::string one) : of(std::move(one)) {}
  TestSubject(const char* one) : of(one) {}
  TestSubject(std::string one, std::string other, std::string scale = {})
      : of(std::move(scale)), first(std::move(one)), second(std::move(other)) {}

  bool empty() const noexcept { return of.empty() && first.empty(); }
  /// In keys of findings and in files of power: "wood", "a|b", "rough: a|b".
  std::string text() const;
  bool operator==(const TestSubject&) const = default;

  std::string of{};
  std::string first{};
  std::string second{};
};

/// The result of a test in English, as printed in a paper.
struct TestSentence {
  std::string test{};  ///< the name of a KindTest
  TestSubject about{};
  TestRole role = TestRole::exploratory;
  bool is_untested = false;
  bool has_mean_interval = false;  ///< the 95 % CI is that of a mean proportion
  bool has_effect = false;
  bool is_significant = false;
  std::optional<double> p{};  ///< corrected, where the test belongs to a family
  /// The smallest attainable p, corrected, where it exceeds 5 %; and the number of participants with a difference other than
  /// zero with which significance would be possible, where it is known.
  std::optional<double> unattainable_p{};
  std::optional<std::size_t> required_n{};
  const TestMethod* made_by = nullptr;  ///< null where the test could not be made
  std::string text{};
};

/// Identifies a finding of an outcome.
struct FindingName {
  std::string analysis{};
  std::string quantity{};
  FindingKey key{};

  auto operator<=>(const FindingName&) const = default;
};
inline FindingName name_of(const Finding& finding) {
  return {finding.analysis, finding.quantity, finding.key};
}

/// Whether the protocol declares a family of tests before data collection.
enum class FamilyDeclaration {
  none,
  declared,
  of_other_kinds,  ///< it names tests, but none of this kind
  differs_between_files,
};

/// The analysis of the responses of one group to one version of one protocol.
struct AnalysisOutcome {
  std::string protocol{};
  std::string version{};
  std::string title{};  ///< of the protocol, in the session that is read last; can be empty
  std::string kind{};
  std::string design{};
  AnswerGroup group = AnswerGroup::people;
  AnswerCount count{};
  FamilyDeclaration family = FamilyDeclaration::none;
  bool declares_sexes = false;                ///< the protocol's family compares women and men
  std::size_t answers = 0;                    ///< attempts that the tables count
  std::vector<AnsweredQuestion> questions{};  ///< the main question of the study first
  std::vector<ResultTable> tables{};
  std::vector<Finding> findings{};
  std::set<FindingName> tests_in_tables{};  ///< tests whose p is in a table, and is reported there
  std::vector<TestSentence> test_sentences{};  ///< in the order of the table of tests
  Phrase
      /// Of that table, where the comparison of women and men is omitted.
      note_of_tests_without_sexes{};
  std::vector<Phrase> remarks{};  ///< sentences that qualify the results
  /// How responses were transformed, where it differs from StudyAnalysis::transformation_of; otherwise empty.
  std::string transformation{};
  Phrase name_of_predictor{};  ///< of magnitude estimates by stimulus; empty: none
  std::string
      unit_of_predictor{};  ///< of it, if it is not part of the name; empty for a pure number
};

}  // namespace asperity
