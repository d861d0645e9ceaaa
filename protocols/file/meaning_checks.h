// Declares the checks of `check_meaning` in one class; each file *_meaning.cpp contains those of one subject.

#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "protocols/design/block_factors.h"
#include "protocols/design/json_pointer.h"
#include "protocols/design/problem_sink.h"
#include "protocols/design/protocol.h"
#include "protocols/design/wording.h"
#include "protocols/file/diagnostic.h"
#include "protocols/file/json_document.h"
#include "protocols/kinds/experiment_kind.h"
#include "protocols/plan/block_rows.h"
#include "protocols/plan/plan.h"
#include "stimuli/properties/parameter.h"

namespace asperity {

// More trials than a participant can complete; a plan of this size is made without a noticeable delay.
inline constexpr std::size_t kMaximumTrials = 2000;
inline constexpr std::size_t kMaximumSessionTrials = 5000;
inline constexpr std::size_t kMaximumRows = 100'000;

template <class Map>
std::vector<std::string> names_of(const Map& map) {
  std::vector<std::string> names{};
  for (const auto& [name, value] : map) names.push_back(name);
  return names;
}

/// "/blocks/NAME/question", or "/blocks/NAME/questions/1".
std::string place_of_question(const Protocol::Block& block, std::size_t question);

/// Checks the complete protocol and collects the problems by location.
class Meaning final : private ProblemSink {
 public:
  Meaning(const Protocol& protocol, const JsonDocument& document,
          const std::vector<ModelDeclaration>& models)
      : protocol_(protocol), kinds_(kinds_of(protocol)), document_(document) {
    for (const ModelDeclaration& model : models) models_.emplace(model.id, &model);
  }

  std::vector<Diagnostic> check();

 private:
  void report(const std::string& pointer, std::string message) override {
    if (!said_.emplace(pointer, message).second) return;
    found_.push_back(document_.at(pointer, std::move(message)));
  }
  void report_key(const std::string& pointer, std::string message) override {
    if (!said_.emplace(pointer, message).second) return;
    found_.push_back(document_.at_key(pointer, std::move(message)));
  }

  void check_head();
  void check_device_limits();
  void check_instability();
  void check_senses();
  void check_blindfold();
  void check_textures();
  void check_path(const std::optional<std::string>& path, const std::string& pointer);
  void check_factors();
  void check_hed(const Factor& factor);
  void check_explorations();
  void check_band(const Band& band, const std::string& pointer);
  void check_guidance(const Exploration& exploration, const std::string& pointer);
  void check_questions();
  /// Of a choice: its options are stated, or can be the surfaces of a trial.
  enum class OptionsOfChoice { stated, surfaces };
  /// Whether the parameters of the forms fit the form, which in a trial need not be stated.
  void check_form(const Question& question, const std::string& pointer, OptionsOfChoice options);
  void check_options(const Question& question, const std::string& pointer);
  void check_participant_questions();
  void check_conditions();
  /// `asked`: the questions that the flow asks before.
  void check_condition(const AnswerCondition& condition, const std::set<std::string>& asked,
                       const std::string& pointer);
  /// Whether the condition at the place states exactly one test.
  bool states_one_test(const std::string& pointer);
  /// Whether an answer to the question can meet the condition at the place.
  void check_test(const AnswerCondition& condition, const Question& question,
                  const std::string& pointer);
  void check_stimulus(const StimulusTemplate& stimulus, const std::string& pointer);
  void check_bodies();
  void check_body_keys(const std::string& name, const std::string& pointer);
  /// Whether a point model touches a body: a surface without a tool.
  static bool is_point_on_body(const StimulusTemplate& stimulus);
  void check_bodies_of(const StimulusTemplate& stimulus,
                       const std::vector<const ModelDeclaration*>& models,
                       const std::string& pointer);
  /// Whether the textures have the files that the models declare.
  void check_assets_of(const StimulusTemplate& stimulus,
                       const std::vector<const ModelDeclaration*>& models,
                       const std::string& pointer);
  /// Whether every surface that the stimulus can have contains its own relief.
  bool brings_its_relief(const StimulusTemplate& stimulus, const std::string& pointer);
  bool is_on_a_body(const StimulusTemplate& stimulus, const std::string& texture,
                    const std::string& pointer);
  /// Checks for values that are valid individually and contradict each other.
  void check_together(const ModelDeclaration& model, const ParameterValues& given,
                      const std::string& pointer);
  void check_equal_force(const StimulusTemplate& stimulus, const std::string& pointer);
  void check_groups();
  /// The factors that the trials of a block have: set by the block, by `run`, or by the participant's group.
  std::set<std::string> factors_of(const Protocol::Block& block, const Protocol::Run* run) const;
  void check_flow();
  void check_break(const Protocol::Break& pause, const std::string& pointer);
  void check_block(const Protocol::Block& block, const std::string& pointer);
  void check_anchor(const Protocol::Block& block, const std::string& pointer);
  void check_anchor_pair(const Protocol::Block& block, const std::string& place);
  void check_presented(const Protocol::Block& block, const std::string& pointer);
  void check_dimension(const Protocol::Block& block, const std::string& pointer);
  bool check_parameter(const Protocol::Block& block, const std::string& pointer);
  bool check_standard(const Protocol::Block& block, const std::string& pointer);
  void check_values(const Protocol::Block& block, const std::string& pointer);
  void check_relative_amplitude(const Protocol::Block& block, const StimulusTemplate& stimulus,
                                const std::string& pointer);
  void check_equal_roughness(const Protocol::Block& block, const std::string& pointer);
  void check_matches(const std::vector<Trial>& possible);
  void check_procedure(const Protocol::Block& block, const std::string& pointer);
  void check_bayesian_procedure(const Protocol::Block& block, const std::string& method,
                                const std::string& pointer);
  void check_unforced(const Protocol::Block& block, const std::string& method,
                      const std::string& pointer);
  void check_pairs_of_standards(const Protocol::Block& block, const std::string& place);
  void check_catch_trials(const Protocol::Block& block, const std::string& pointer);
  void check_track_starts(const Protocol::Block& block, const std::string& pointer);
  void check_arrangement(const Protocol::Block& block, const std::string& pointer);
  void check_exposure(const Protocol::Block& block, const std::string& place);
  void check_strokes_of_visit(const Protocol::Block& block, const Exploration& exploration,
                              const std::string& place);
  void check_side_by_side(const Protocol::Block& block, const std::string& place);
  void check_drawn_phase(const Protocol::Block& block, const std::string& place);
  void check_rove(const Protocol::Block& block, const std::string& place);
  void check_plane_models(const Protocol::Block& block, const std::string& at,
                          const std::string& what);
  void check_shared_pairs(const Protocol::Block& block, const std::string& pointer);
  void check_pairs(const Protocol::Block& block, const std::string& pointer);
  void check_question(const Protocol::Block& block, const std::string& pointer);
  void check_condition_in_trial(const Protocol::Block& block, std::size_t question);
  /// Where the options are known: those of all trials of the block.
  void check_tests_in_trials(const std::vector<Trial>& possible);
  bool check_question_keys(const Protocol::Block& block, const std::string& pointer);
  void check_additional(const Protocol::TrialQuestionTemplate& question, const std::string& place);
  void check_direction(const Protocol::TrialQuestionTemplate& question, const std::string& place);
  void check_pictures(const Protocol::Block& block, const Protocol::TrialQuestionTemplate& question,
                      const std::string& place);
  void check_same_form(const Protocol::Block& block,
                       const Protocol::TrialQuestionTemplate& question, const std::string& place);
  void check_same_scale(const Protocol::Block& block,
                        const Protocol::TrialQuestionTemplate& question, const std::string& place);
  void check_confidence(const Protocol::Block& block,
                        const Protocol::TrialQuestionTemplate& question, const std::string& place);
  void check_scale(const Protocol::TrialQuestionTemplate& question, const std::string& place);
  void check_scale_form(const ScaleForm& scale, const std::string& at);
  void check_rows(const Protocol::Block& block, const std::string& pointer);
  void check_derived(const Protocol::Block& block, const std::string& pointer);
  void check_repetitions_of(const Protocol::Block& block, const std::vector<BlockRow>& rows,
                            const std::string& pointer);
  void check_order(const Protocol::Block& block, const std::string& pointer);
  std::vector<std::vector<BlockRow>> extreme_parts(const Protocol::Block& block) const;
  void check_balance(const Protocol::Block& block, const std::string& pointer);
  void check_constraints(const Protocol::Block& block, const std::string& pointer);
  void check_possible_order(const Protocol::Block& block, const std::vector<BlockRow>& rows,
                            const std::vector<BlockTrial>& trials, const std::string& pointer);
  void check_places(const Protocol::Block& block, const std::vector<BlockRow>& rows,
                    const std::vector<BlockTrial>& trials, const std::string& pointer);
  /// Whether every row of the block has a level of the factor that is not computed.
  bool is_row_factor(const Protocol::Block& block, const std::string& factor) const;
  /// Reports factors and levels that the rows of the block do not have.
  bool check_row_levels(const Protocol::Block& block, const FactorLevels& levels,
                        const std::string& pointer);
  void check_criterion(const Protocol::Block& block, const std::string& pointer);
  /// Whether the placeholders of texts have a form, a name, and a value where they are.
  void check_texts();
  void check_analysis();
  void check_constructs();
  /// The items that can be chosen in main blocks, for the check of the declared target.
  std::set<std::string> items_of_main_blocks();
  void check_size();
  void check_trials();
  void check_draws();
  void check_expectation(const Trial& trial, const std::set<std::string, std::less<>>& on_bodies);

  /// The texts that a binding can have, each with the location for problems.
  std::vector<std::pair<std::string, std::string>> texts_of(const Binding<std::string>& binding,
                                                            const std::string& pointer);
  /// The position of a level of a factor: of the formula, where the level is computed.
  std::string place_of_level(const std::string& factor, std::size_t level) const;
  bool check_level(const std::string& factor, const Level& level, const std::string& pointer);
  const Protocol& protocol_;
  std::vector<const ExperimentKind*> kinds_{};  ///< of the blocks
  const JsonDocument& document_;
  std::map<std::string, const ModelDeclaration*, std::less<>> models_{};
  std::vector<Diagnostic> found_{};
  std::set<std::pair<std::string, std::string>> said_{};
};

}  // namespace asperity
