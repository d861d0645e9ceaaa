// The analysis of one kind of experiment, as a value, and the registry of all analyses.

#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/words/phrase.h"
#include "app/findings/gathering/gathered_answers.h"
#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/outcome/estimate_sentences.h"
#include "app/findings/outcome/shown_parameters.h"
#include "app/findings/outcome/study_test.h"
#include "protocols/design/protocol.h"

namespace asperity {

/// The result of a test of a kind, as a clause in English. %1 and %2 are the subjects of the test,
/// %3 is " of 25 %" after the chance level, where the test has one, %4 " on the scale “rough”", where items
/// are compared on one of several, and %5 " (wood)", where groups are compared in one of several numbers. Of tests that are not confirmatory the word "significantly " is left out.
struct TestClaim {
  std::string_view test{};    ///< a KindTest of the kind
  std::string_view method{};  ///< where the clause is for one method: its code; these come first
  std::string_view higher{};  ///< significant, the statistic positive or without a sign
  /// Significant, the statistic negative; empty where that is impossible.
  std::string_view lower{};
  std::string_view nothing{};
};

/// Everything that differs between kinds once there are responses: tables, findings and sentences.
/// The counterpart before that is ExperimentKind (protocols/kinds/experiment_kind.h); a test
/// compares both registries.
struct StudyAnalysis {
  std::string_view kind{};    ///< the id of the ExperimentKind
  Phrase name{};              ///< "magnitude estimation"
  bool scores_items = false;  ///< a response has several items, each correct or incorrect
  std::span<const TestClaim> claims{};

  /// The task in a sentence of a report: "Task: in each trial, …"
  std::string (*task)(const Protocol& protocol) = nullptr;
  /// The end of the sentence "In each trial, two stimuli were presented" of a text for a paper. It cites publications by
  /// their keys in brackets: "[Levitt 1971]" (Reference::key).
  std::string (*task_for_paper)(const Protocol& protocol) = nullptr;
  /// The model that is fitted to the responses and its intervals, in sentences of a text for a paper; null where the
  /// methods of the tests state all. Sentences on what not every outcome contains depend on the outcome.
  std::string (*fit_for_paper)(const Protocol& protocol, const AnalysisOutcome& outcome) = nullptr;
  /// How responses were transformed before the analysis, as a sentence of a text for a paper; or empty.
  std::string_view transformation{};
  /// The same where it depends on the protocol; null where it does not.
  std::string (*transformation_of)(const Protocol& protocol) = nullptr;

  /// Tables, findings and questions of the responses of one group.
  void (*analyze)(const GatheredAnswers& gathered, AnalysisOutcome& outcome) = nullptr;
  /// The tests of the family with their correction, as `analyze` reports them, and nothing else that it computes, for
  /// analyses of many simulated studies. Null where only `analyze` has them.
  std::vector<StudyTest> (*test_family)(const GatheredAnswers& gathered) = nullptr;
  /// What the responses to a question show of the parameters of its response table; null where nothing.
  ShownParameters (*shown_parameters)(const GatheredAnswers& gathered,
                                      const TabulatedQuestion& asked) = nullptr;
  /// The estimates in a sentence; null where the tests state them.
  EstimateSentence (*estimates)(const AnalysisOutcome& outcome) = nullptr;
};

/// All analyses, in the order of experiment_kinds().
std::span<const StudyAnalysis* const> study_analyses();

/// Null for a kind that this program does not have.
const StudyAnalysis* find_analysis(std::string_view kind) noexcept;

/// "paired comparison" in English; the id of a kind that this program does not have.
std::string name_of_kind(std::string_view kind);

}  // namespace asperity
