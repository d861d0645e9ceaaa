// What distinguishes one kind of experiment from another, as a value, and the registry of all kinds.

#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/numbers/random.h"
#include "analysis/signals/force_features.h"
#include "protocols/answers/question.h"
#include "protocols/design/problem_sink.h"
#include "protocols/design/protocol.h"
#include "protocols/design/trial.h"
#include "protocols/observer/virtual_observer.h"

namespace asperity {

/// The roles of the surfaces in kinds that have only one.
inline constexpr std::array<std::string_view, 1> kTargetRole{"target"};
inline constexpr std::array<std::string_view, 1> kAlternativeRole{"alternative"};

/// A group of tests of a kind, by the name under which a protocol can take it into its family.
struct KindTest {
  std::string_view name{};
  std::string_view meaning{};  ///< what it answers, as on the page of the format: "whether …"
  /// Only with a declared target (AnalysisDeclaration::target).
  bool needs_target = false;
  /// Of magnitude estimates: the key of "estimation" with which it is possible, "spacing" or "factor"; empty: with both.
  std::string_view estimated_by{};
  /// Of one by spacing: the test of any other stimuli with the same question; empty: none.
  std::string_view by_factor{};
};

/// A key at the root of a protocol that a kind needs.
struct RequiredKey {
  std::string_view name{};
  Phrase if_missing{};  ///< the problem, reported at "kind"
};

/// One block whose question is being checked.
struct BlockOfKind {
  const Protocol& protocol;
  const Protocol::Block& block;
  const Protocol::TrialQuestionTemplate& question;
  std::string pointer{};      ///< "/blocks/NAME"
  std::string at_question{};  ///< "/blocks/NAME/question"
};

struct VirtualResponse {
  Answer answer{};
  bool is_guess = false;  ///< made without an expectation
  /// VirtualObserver::certainty of a decision with a criterion.
  std::optional<double> certainty{};
};

/// What a virtual participant has to judge, and on what basis.
struct Judgement {
  const Protocol& protocol;
  const Trial& trial;
  const Question& question;
  std::span<const ForceFeatures> felt{};  ///< by position
  const Expectations& expectations;       ///< by texture
  VirtualObserver& observer;
  Random of_attempt;      ///< for guesses
  Random of_participant;  ///< for the habits of a participant, the same in all trials
  /// The response whose confidence the question rates (`confidence_of`); null for all other questions.
  const VirtualResponse* rated = nullptr;
};

struct ResponseTable;

/// A kind of experiment. Everything that differs between kinds before the data are analysed is here;
/// the counterpart for the analysis is StudyAnalysis (app/findings/outcome/study_analysis.h).
///
/// A function that is null does nothing. Functions report problems, and do not throw.
struct ExperimentKind {
  std::string_view id{};  ///< as in protocols and in the store: "magnitude"
  Phrase name{};          ///< in messages, after "a": "magnitude estimation"
  /// Of the surfaces of a trial; the first one where a protocol states none.
  std::span<const std::string_view> roles{};
  AnswerForm form{};                       ///< how its question is answered
  std::optional<AnswerForm> other_form{};  ///< or by this one, where its key is stated
  /// A trial may have several questions of this kind, also next to the question of another kind.
  bool asks_several = false;
  std::string_view anchor_role{};  ///< of the only surface of an anchor; empty: as in other trials
  bool has_expectations = false;   ///< a virtual observer judges by what it expects of textures
  std::span<const KindTest> tests{};  ///< the first is the family where a protocol declares none
  std::span<const RequiredKey> required{};

  /// The factor whose level a surface counts as in the responses, unless the protocol names the surface; empty: item_of.
  std::string (*item_factor)(const Protocol& protocol) = nullptr;
  /// What a surface counts as otherwise.
  std::string (*item_of)(const PlannedPresentation& surface) = nullptr;
  /// The correct responses to the trial, one per item of the answer.
  std::vector<std::string> (*correct_of)(const Protocol::TrialQuestionTemplate& question,
                                         const Trial& trial) = nullptr;

  /// The whole protocol, once its factors, textures and blocks have been checked.
  void (*check)(const Protocol& protocol, ProblemSink& problems) = nullptr;
  /// One block and its question.
  void (*check_block)(const BlockOfKind& checked, ProblemSink& problems) = nullptr;
  /// One of the trials that can occur.
  void (*check_trial)(const BlockOfKind& checked, const Trial& trial,
                      ProblemSink& problems) = nullptr;

  /// The response of a virtual participant.
  VirtualResponse (*judge)(const Judgement& judgement) = nullptr;
  /// How responses are simulated without rendering (response_table.h); null where they cannot be.
  const ResponseTable* responses = nullptr;
};

/// Null where the kind has no test of this name.
const KindTest* find_test(const ExperimentKind& kind, std::string_view name) noexcept;

/// The test that is the family where a protocol declares none: the first one of the kind; of estimates of stimuli without
/// spacings that of the stimuli, or of the predictor.
std::string_view default_test_of(const ExperimentKind& kind,
                                 const EstimationDeclaration& estimation) noexcept;
/// The tests of the kind that are corrected together: those of the declared family, or the default one where it has none. Of
/// questions that only accompany those of another kind there is no default one, and groups are not compared.
std::vector<std::string> family_of(const ExperimentKind& kind, const AnalysisDeclaration& analysis,
                                   const EstimationDeclaration& estimation, bool only_accompanies);

/// All kinds, in the order in which documents list them.
std::span<const ExperimentKind* const> experiment_kinds();

/// Null where there is no such kind.
const ExperimentKind* find_kind(std::string_view id) noexcept;

/// Errors: std::logic_error where there is no such kind; a protocol that was read has one.
const ExperimentKind& kind_named(std::string_view id);

const ExperimentKind& kind_of(const Protocol::Block& block);
/// The kind that analyses a question in a block of kind `of_block`: that kind where its form is answered there, or
/// otherwise the kind with this form that can accompany others. Null where there is none, and for an additional question.
const ExperimentKind* kind_of_question(const ExperimentKind& of_block,
                                       const Question& question) noexcept;
/// The kinds of the blocks of a protocol, in the order of the registry.
std::vector<const ExperimentKind*> kinds_of(const Protocol& protocol);
/// The kinds of the questions of its main blocks, in the same order: those whose responses are analysed.
std::vector<const ExperimentKind*> analysed_kinds_of(const Protocol& protocol);

}  // namespace asperity
