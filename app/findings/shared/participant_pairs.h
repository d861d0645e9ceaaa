// Compares two groups of participants: women and men, or two groups to which the protocol assigns participants.

#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/numbers/proportion.h"
#include "app/findings/gathering/answer_columns.h"
#include "app/findings/gathering/gathered_answers.h"
#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/outcome/study_tests.h"

namespace asperity {

/// Two levels of an attribute of the participants.
struct ParticipantPair {
  const char* test = kSexesTest;  ///< the name of its test, which other pairs may share
  std::string analysis{};         ///< the name of its question, and the analysis of its findings
  std::string equivalence{};      ///< the same for the question of equivalence
  std::string first{};            ///< the levels in tables and findings: "F", "M"
  std::string second{};
  Phrase first_name{};  ///< in sentences: "women"
  Phrase second_name{};
  Phrase question{};
  Phrase equivalence_question{};
  /// Of the gathered people, in their order; empty for participants with neither level.
  std::vector<std::string> levels{};
  /// Likewise AnsweringPerson::block; empty where labels are exchanged between all.
  std::vector<std::string> blocks{};

  TestSubject about() const { return {first, second}; }
};

/// The table for a family that compares the two levels of a pair, filled row by row.
class PairRows final {
 public:
  PairRows(const GatheredAnswers& gathered, const ParticipantPair& pair)
      : gathered_(gathered), pair_(pair) {}

  /// Adds a row of a participant, by index of the gathered people; false for one with neither level.
  bool add(std::size_t person);
  /// Nothing without participants of both levels. `further`: the columns after `subject` and `group`.
  std::optional<TidyInput> take(std::vector<TidyTable::Column> further) &&;

 private:
  const GatheredAnswers& gathered_;
  const ParticipantPair& pair_;
  LabelRows subjects_{};
  LabelRows levels_{};
  LabelRows blocks_{};
  std::array<bool, 2> has_{};
};

/// Which permutations of the group labels a test uses.
Phrase method_of_splits(const StudyTest& test);

ParticipantPair women_and_men(const GatheredAnswers& gathered);
/// Every pair of the groups that the protocol declares, in its order; none without groups.
std::vector<ParticipantPair> pairs_of_groups(const GatheredAnswers& gathered);

/// The scale on which a pair is compared.
enum class PairScale { shares_of_answers, shares_of_items, items, shares_of_target };

/// The means of the participants of either level with their intervals, and the difference (first −
/// second).
struct PairMeans {
  std::optional<Finding> first{};
  std::optional<Finding> second{};
  std::optional<Finding> difference{};
  PairScale scale = PairScale::shares_of_answers;
  std::string target{};  ///< of shares_of_target
};
/// Whether the two differ; nothing where there are no participants of both.
void ask_pair(const ParticipantPair& pair, const PairMeans& means, const StudyTests& tests,
              AnalysisOutcome& outcome);

/// Compares the proportions of the participants of several pairs with the family `group`.
class PairComparisons final {
 public:
  /// `own`: hits and trials of each of the gathered people, in their order. Pairs without
  /// participants of both levels are left out.
  PairComparisons(const GatheredAnswers& gathered, const std::vector<ParticipantPair>& pairs,
                  std::span<const HitCount> own);

  /// Keeps the findings, and adds a test for each pair.
  void add_tests(StudyTests& tests, AnalysisOutcome& outcome) const;
  /// Once the tests are finished: whether each pair differs and, except for choices of a target,
  /// whether it is equivalent.
  void ask(PairScale scale, const std::string& target, const StudyTests& tests,
           AnalysisOutcome& outcome) const;

 private:
  struct Compared {
    ParticipantPair pair{};
    std::vector<Finding> findings{};
  };
  const GatheredAnswers& gathered_;
  std::vector<std::optional<double>> proportions_{};
  std::vector<Compared> compared_{};
};

}  // namespace asperity
