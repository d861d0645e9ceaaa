// Completes the stated settings of a procedure with defaults from its grid, origin and guess rate.

#include "protocols/file/levels_from_json.h"

#include <algorithm>
#include <utility>

#include <nlohmann/json.hpp>

#include "protocols/keys/reading.h"
#include "protocols/keys/tables.h"

namespace asperity {

using Block = Protocol::Block;
using nlohmann::json;

namespace {

/// The parameter of one of the models that the stimulus can have; null if none has it.
const Parameter* parameter_of(const std::vector<ModelDeclaration>& models, const std::string& id,
                              const std::string& name) {
  for (const ModelDeclaration& model : models) {
    if (!id.empty() && model.id != id) continue;
    for (const Parameter& parameter : model.parameters) {
      if (parameter.name == name) return &parameter;
    }
  }
  return nullptr;
}

using Declaration = ProcedureDeclaration;

PosteriorTrack track_stated(const Declaration& stated, const Dimension& dimension,
                            const DiscriminationDesign& design) {
  PosteriorTrack track{.grid = dimension.grid.value_or(LevelGrid{}),
                       .origin = dimension.level_of_standard()};
  const auto& prior = stated.prior;
  track.prior.thresholds = prior.threshold.value_or(thresholds_within(track.grid, track.origin));
  track.prior.slopes = prior.slope.value_or(track.prior.slopes);
  track.prior.lapses = prior.lapse.value_or(track.prior.lapses);
  track.prior.guess_rate = design.guess_rate();
  track.prior.performance = stated.target.value_or(0.5 * (1.0 + track.prior.guess_rate));
  track.stop = {.trials = stated.stop.trials, .interval = stated.stop.interval};
  return track;
}

/// The levels of a dimension, if they are stated.
std::vector<double> levels_stated(const Dimension& dimension) {
  return has_levels(dimension) ? dimension.levels() : std::vector<double>{};
}

ProcedureSettings settings_of(const Declaration& stated, const Declaration::Track& track,
                              const Dimension& dimension, const DiscriminationDesign& design) {
  const LevelGrid grid = dimension.grid.value_or(LevelGrid{});
  const double start = track.start.value_or(stated.start);
  const StopRules stop{.trials = stated.stop.trials,
                       .reversals = stated.stop.reversals,
                       .clipped_moves = stated.stop.clipped_moves};
  // The steps of one direction: those of this direction, or those of both.
  const StepList& steps_up = stated.steps_up.empty() ? stated.steps : stated.steps_up;
  const StepList& steps_down = stated.steps_down.empty() ? stated.steps : stated.steps_down;
  if (stated.method == transformed_up_down().id) {
    return TransformedUpDown{{.grid = grid,
                              .start = start,
                              .rule = {.up = stated.up, .down = stated.down},
                              .steps_up = steps_up,
                              .steps_down = steps_down,
                              .stop = stop}};
  }
  if (stated.method == weighted_up_down().id) {
    return WeightedUpDown{.grid = grid,
                          .start = start,
                          .target = stated.target.value_or(WeightedUpDown{}.target),
                          .steps_down = steps_down,
                          .stop = stop};
  }
  if (stated.method == psi().id) {
    return Psi{.track = track_stated(stated, dimension, design),
               .marginalised = stated.marginalised};
  }
  if (stated.method == external().id) {
    return External{.levels = levels_stated(dimension),
                    .trials = stated.stop.trials,
                    .settings_json = stated.settings_json,
                    .answer_within_s = stated.answer_within_s};
  }
  if (stated.method == quest_plus().id) {
    return QuestPlus{.track = track_stated(stated, dimension, design)};
  }
  return ConstantStimuli{.levels = levels_stated(dimension), .repetitions = stated.repetitions};
}

}  // namespace

void complete_dimension(Block& block, const Protocol& protocol,
                        const std::vector<ModelDeclaration>& models) {
  Dimension& dimension = *block.vary;
  std::string model{};
  for (const Protocol::Presented& presented : block.presented) {
    const auto stimulus = protocol.stimuli.find(presented.stimulus);
    if (stimulus == protocol.stimuli.end()) continue;
    if (presented.role == dimension.role) model = stimulus->second.model.value.value_or("");
    if (presented.role != dimension.standard_role) continue;
    if (dimension.is_relative_amplitude()) {
      dimension.standard = 1.0;
      continue;
    }
    const auto stated = stimulus->second.parameters.find(dimension.parameter);
    if (stated == stimulus->second.parameters.end() || !stated->second.value) continue;
    if (const auto* const number = std::get_if<double>(&*stated->second.value)) {
      dimension.standard = *number;
    }
  }
  if (dimension.is_relative_amplitude()) {
    dimension.meaning =
        "Factor by which the amplitude of the texture is multiplied: the amplitude parameter of "
        "the force "
        "model, whatever determines its value otherwise";
    return;
  }
  const Parameter* const parameter = parameter_of(models, model, dimension.parameter);
  if (parameter == nullptr) return;
  dimension.unit = parameter->unit;
  dimension.meaning = parameter->meaning.english();
}

void declare_dimension(Block& block, Protocol& protocol, const std::set<std::string>& of_file) {
  const Dimension& dimension = *block.vary;
  if (!has_levels(dimension) || of_file.contains(dimension.factor)) return;
  Factor& factor = protocol.factors[dimension.factor];
  factor.name = dimension.factor;
  if (factor.meaning.empty() && factor.unit.empty()) {
    factor.meaning = dimension.meaning;
    factor.unit = dimension.unit;
  }
  std::vector<double> values = dimension.values();
  if (block.procedure && block.procedure->catch_trials) {
    values.push_back(dimension.value_of(block.procedure->catch_trials->level));
  }
  if (const auto anchor = block.anchor.find(dimension.factor); anchor != block.anchor.end()) {
    if (const auto* const level = std::get_if<double>(&anchor->second)) {
      values.push_back(dimension.value_of(*level));
    }
  }
  for (const double value : values) {
    if (std::find(factor.levels.begin(), factor.levels.end(), Level(value)) ==
        factor.levels.end()) {
      factor.levels.emplace_back(value);
    }
  }
  std::sort(factor.levels.begin(), factor.levels.end());
}

void declare_unforced(std::size_t alternatives, std::vector<ProcedureSettings>& tracks) {
  for (ProcedureSettings& track : tracks) {
    if (auto* const weighted = std::get_if<WeightedUpDown>(&track)) {
      weighted->unforced_alternatives = alternatives;
    }
  }
}

Block::LevelProcedure procedure_in(const json& object, const Dimension& dimension,
                                   const DiscriminationDesign& design) {
  Declaration stated{};
  read_keys(kProcedureTable, object, "", stated);
  if (stated.tracks.empty()) stated.tracks.emplace_back();
  Block::LevelProcedure procedure{.timeouts_are_incorrect = stated.timeouts_are_incorrect};
  for (const Declaration::Track& track : stated.tracks) {
    procedure.tracks.push_back(settings_of(stated, track, dimension, design));
  }
  if (const auto& trials = stated.catch_trials) {
    const bool is_of_standard = trials->type != CatchType::easy && dimension.standard;
    procedure.catch_trials = {
        .type = trials->type,
        .level = trials->level.value_or(is_of_standard ? dimension.level_of_standard() : 0.0),
        .every = trials->every};
  }
  return procedure;
}

}  // namespace asperity
