// Collects the tests of a study, applies Holm's correction over its family, and makes the table
// that reports them.

#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/findings/outcome/study_test.h"

namespace asperity {

/// The tests of a study, with Holm's correction over those of its family.
class StudyTests final {
 public:
  /// The table of all tests, and the analysis that its findings belong to.
  static constexpr const char* kTable = "tests";
  /// The status of a permutation test of one participant, whose p could only be 1.
  static constexpr const char* kOneParticipantAlone = "cannot be tested with one participant";

  /// The status of a signed-rank test of several participants of whom only one has a difference other than zero: its p could
  /// only be 1. A code of cell_words.h.
  static constexpr const char* kOneDifference = "one_difference";
  /// The status where all their differences are zero. A code of cell_words.h.
  static constexpr const char* kNoDifference = "no_difference";

  /// The family that the protocol declares, or the first test of its kind. Without a declaration,
  /// scales that only accompany other questions have no family.
  explicit StudyTests(const GatheredAnswers& gathered);
  /// Of a study in which the first test of the kind cannot be asked. Keeps a declared family.
  void set_default_family(std::vector<std::string> names);

  using Test = StudyTest;
  /// The column of the table that names the test, and the comparison it is about.
  static const ResultColumn& test_column();

  /// Adds the test whose p is the quantity `p` with this key. A p that is not a number is the
  /// reason that there is no test; within the study's family such a test counts as p = 1.
  void add(const std::string& name, const TestSubject& about, const FoundNumbers& found,
           QuantityName p, const FindingKey& key = {});
  /// A test that cannot be made. `reason`: a code of cell_words.h, or a sentence.
  void add_untested(const std::string& name, const TestSubject& about, const std::string& reason);
  /// Sets the number of participants left out of the test that was added last. `why`: a sentence without its end, which
  /// the number follows in the note below the table; may be empty.
  void leave_out(std::size_t participants, const Phrase& why);
  /// Of the last test: participants that it drops because their two values are equal. The note below the table lists them.
  void drop_ties(std::size_t participants) { tests_.back().ties = participants; }
  /// See StudyTest.
  void permute_within_blocks() { tests_.back().permutes_within_blocks = true; }
  /// Sets the proportion expected under guessing for the same test. `varies`: between trials; it is the mean over participants.
  void state_chance(double chance, bool varies = false);
  /// Of the same test: the effect in the unit of the responses, with its interval. Null: there is none. `name`: a constant.
  void state_effect(const Finding* effect, std::string_view name);
  /// Of the same test: the estimate that is stated with it, and its value without an effect; `contained`: the clause where
  /// its interval contains this value. Null: there is none.
  void state_compared(const Finding* compared, double none, const Phrase& contained);
  void state_difference(const Finding* difference);  ///< as above; none: 0
  void state_ratio(const Finding* ratio);            ///< none: 1
  void state_mean_share(const Finding* mean, double chance);
  /// Of the same test: the difference of two stated means, whose sign is to be that of the test. Nothing: there is none.
  void state_direction(std::optional<double> difference);
  /// Adjusts, and appends the table `kTable` with its findings. A test that the protocol declares
  /// and that was not added is a row without a p. Without a test no table is appended.
  void finish(AnalysisOutcome& outcome);
  /// Adjusts, and returns the tests of the family alone, in the order in which they were added: what `finish` reports of
  /// them, without tables and sentences.
  std::vector<Test> take_family() &&;

  const Test* find(std::string_view name, const TestSubject& about = {}) const;
  std::span<const Test> tests() const noexcept { return tests_; }
  bool is_in_family(std::string_view name) const;
  const std::string& family() const noexcept { return name_; }
  bool is_declared() const noexcept { return is_declared_; }

 private:
  /// Sets the name of the family from its tests.
  void name_family();
  /// Adds the tests of the family that were not added, with the reason why there are none.
  void add_missing();
  /// Applies Holm's correction to the p of the family, and to the smallest attainable ones.
  void adjust();
  /// The smallest number of participants with a difference other than zero with which a test that permutes signs can be
  /// significant.
  std::optional<std::size_t> required_participants(const Test& test) const;
  std::size_t tests_in_family() const;
  /// The note below the table: the number of tests in the family, and the contents of the columns,
  /// without the symbols of the tests that are called `left_out`.
  Phrase note_on_family(std::size_t tests, std::string_view left_out = {}) const;
  Phrase note_on_columns(std::string_view left_out) const;
  /// The tests with participants whose difference is zero, and how many they are; empty without such a test. Signed-rank
  /// tests first, which do not count them in n, then sign-flip tests.
  Phrase note_on_zero_differences() const;

  std::string kind_{};
  std::size_t people_ = 0;
  std::vector<std::string> family_{};
  std::string name_{};
  bool is_declared_ = false;
  bool is_of_other_kinds_ = false;  ///< the declared family, which has no test of this kind
  std::vector<Test> tests_{};
};

}  // namespace asperity
