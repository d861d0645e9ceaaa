// Collects the tests of a study, applies Holm's correction over its family, and makes the table
// that reports them.

#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/findings/found_numbers.h"
#include "app/findings/study/analysis_outcome.h"
#include "app/findings/study/test_methods.h"

namespace asperity {

/// The tests of a study, with Holm's correction over those of its family.
class StudyTests final {
 public:
  /// The table of all tests, and the analysis that its findings belong to.
  static constexpr const char* kTable = "tests";
  /// The status of a permutation test of one participant, whose p could only be 1.
  static constexpr const char* kOneParticipantAlone = "cannot be tested with one participant";

  /// The family that the protocol declares, or the first test of its kind.
  explicit StudyTests(const GatheredAnswers& gathered);

  struct Test {
    std::string name{};   ///< the name of a KindTest
    std::string about{};  ///< which of several comparisons is tested; may be empty
    const TestMethod* made_by = nullptr;
    std::string method{};
    std::size_t n = 0;  ///< of the units that contributed
    std::string unit{kUnitOfParticipants};
    /// Participants who responded and do not contribute, because they have nothing that can be
    /// exchanged.
    std::size_t left_out = 0;
    std::optional<double> p{};
    FindingName source{};  ///< the finding that has its p
    /// The smallest attainable p, Holm-corrected for a test of the family: above 5 %, significance
    /// is impossible.
    std::optional<double> smallest_p{};
    std::optional<double> statistic{};
    std::vector<double> degrees{};    ///< of freedom: none, one, or two of an F; uncorrected
    /// The ε that corrects them; nothing where they are not corrected.
    std::optional<double> epsilon{};
    std::optional<std::size_t>
        random_permutations{};  ///< 0: all were counted; nothing: not permuted
    struct Effect {
      double value = 0.0;
      std::optional<double> low{};
      std::optional<double> high{};
      bool takes_trials_as_independent = false;  ///< in a test of participants
    };
    std::optional<Effect> effect{};
    std::optional<Effect> estimate{};   ///< the proportion that is tested
    std::optional<double> chance{};     ///< the chance level of that proportion
    std::optional<double> adjusted{};   ///< within the family
    bool is_alone_in_family = false;    ///< the only test of its family, so that p is not corrected
    TestRole role = TestRole::exploratory;
    bool pools_participants = false;  ///< n counts responses of more than one participant
    std::string status = "ok";

    /// Only a test of the family can be significant here; adjusted within it, at 5 %.
    bool shows() const noexcept { return adjusted && *adjusted < 0.05; }
    /// Significant at 5 %, for tests outside the family without correction.
    bool is_significant() const noexcept { return adjusted ? shows() : p && *p < 0.05; }
  };
  /// Adds the test whose p is the quantity `p` with this key. A p that is not a number is the
  /// reason that there is no test; within the study's family such a test counts as p = 1.
  void add(const std::string& name, const std::string& about, const FoundNumbers& found,
           std::string_view p, std::string_view key = {});
  /// A test that cannot be made. `reason`: a code of cell_words.h, or a sentence.
  void add_untested(const std::string& name, const std::string& about, const std::string& reason);
  /// Sets the number of participants left out of the test that was added last.
  void leave_out(std::size_t participants);
  /// Sets the proportion expected under guessing for the same test.
  void state_chance(double chance);
  /// Adjusts, and appends the table `kTable` with its findings. A test that the protocol declares
  /// and that was not added is a row without a p.
  void finish(AnalysisOutcome& outcome);

  const Test* find(std::string_view name, std::string_view about = {}) const;
  std::span<const Test> tests() const noexcept { return tests_; }
  bool is_in_family(std::string_view name) const;
  const std::string& family() const noexcept { return name_; }
  bool is_declared() const noexcept { return is_declared_; }

 private:
  /// Applies Holm's correction to the p of the family, and to the smallest attainable ones.
  void adjust();
  std::size_t tests_in_family() const;
  /// The note below the table: the number of tests in the family, and the contents of the columns,
  /// without the symbols of the tests that are called `left_out`.
  Phrase note_on_family(std::size_t tests, std::string_view left_out = {}) const;
  Phrase note_on_columns(std::string_view left_out) const;

  std::string kind_{};
  std::size_t people_ = 0;
  std::vector<std::string> family_{};
  std::string name_{};
  bool is_declared_ = false;
  std::vector<Test> tests_{};
};

/// A table for display (reading_table.h). In the table of tests a statistic is combined with its
/// degrees of freedom and its value in one cell, "t(19) = 12.25", an effect size with its interval
/// in another, "d = 2.74 [1.75, 3.71]".
Table reading_table(const NamedTable& table);

/// "p = .031, uncorrected"; for the family "p = .062, Holm-corrected", or "p = .062, the only
/// confirmatory test". Where no p of 5 % could be attained, with the smallest attainable one.
/// Without a declaration no test is confirmatory.
Phrase p_text(const StudyTests::Test& test);
/// The sentences about a test that was made: `claim` if it is significant, `nothing` if it is not,
/// and `told` for a test outside the family, with the sentence that it is exploratory.
struct Sayings {
  Phrase claim{};
  Phrase nothing{};
  Phrase told{};
};
Phrase said_of(const StudyTests::Test& test, const Sayings& sayings);

}  // namespace asperity
