// Reports the scales that accompany questions of other kinds, such as a rating of confidence after a recognition.

#pragma once

#include <string>
#include <vector>

#include "app/findings/gathering/gathered_answers.h"
#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/outcome/study_tests.h"

namespace asperity {

/// A mean rating: "62.50 (95 % CI [51.20, 73.80])".
Phrase rating_text(const Finding& mean);

/// Ratings that are about a trial and its response, not an attribute of the presented item.
///
/// A participant's ratings are averaged over trials first: over all of them, over those with correct
/// and with incorrect responses to the accompanied question, or by the chosen item where no response
/// is correct or incorrect, and by the presented item where each trial presents one. Means are those
/// of the participants who have such trials, with t-based 95 % CIs. The paired t test compares the
/// means of correct and incorrect responses of the participants who have both.
class AccompanyingScales final {
 public:
  explicit AccompanyingScales(const GatheredAnswers& gathered);

  bool empty() const noexcept { return scales_.empty(); }
  /// Whether the ratings on a scale of this name are among them.
  bool has(const std::string& scale) const;
  /// "the trials with correct and over those with incorrect responses", in a text for a paper.
  std::string groups_text() const;
  /// Adds the test `accompanying_scales` of every scale with correct and incorrect responses.
  void add_tests(StudyTests& tests) const;
  /// Adds the table `accompanying`, the findings, and a question for every scale.
  void report(const StudyTests& tests, AnalysisOutcome& outcome) const;

 private:
  /// A scale next to one question.
  struct Scale {
    std::string name{};
    std::string question{};  ///< that it accompanies
    std::vector<Finding> findings{};
    std::vector<Finding> comparison{};  ///< of correct and incorrect responses; may be empty
    /// mean.score.compared, keys "…|correct" and "…|incorrect": the means of the participants who have both, as in `comparison`.
    std::vector<Finding> compared_means{};
    std::size_t left_out = 0;  ///< participants without both
    /// The groups of trials in the order of the table: of all trials, and by a property of the trial.
    struct Group {
      std::string by{};     ///< "all", "correctness", "chosen", "presented"
      std::string level{};  ///< empty for all trials
      std::size_t responses = 0;

      FindingKey key(const Scale& scale) const;
    };
    std::vector<Group> groups{};

    FindingKey key() const { return {name, question}; }
    /// The subject of its test, which compares correct and incorrect responses.
    TestSubject about() const { return {name, question}; }
  };
  static Phrase answer_text(const Scale& scale, const StudyTests& tests);
  /// In the sentence of its test.
  static void state_means_of(const Scale& scale, AnalysisOutcome& outcome);

  std::vector<Scale> scales_{};
};

}  // namespace asperity
