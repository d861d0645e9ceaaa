#include "protocols/file/levels_from_json.h"

#include <algorithm>
#include <utility>

#include <nlohmann/json.hpp>

#include "protocols/file/json_reading.h"

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

LevelGrid grid_of(const json& object) {
  LevelGrid grid{};
  read(object, "lowest", grid.lowest);
  read(object, "highest", grid.highest);
  read(object, "step", grid.step);
  read_choice(object, "scale", grid.scale,
              {{"linear", LevelScale::linear},
               {"log10", LevelScale::log10},
               {"db", LevelScale::decibel},
               {"ratio", LevelScale::ratio}});
  return grid;
}

void read_range(const json& object, const char* key, ValueRange& range) {
  const auto found = object.find(key);
  if (found == object.end()) return;
  read(*found, "lowest", range.lowest);
  read(*found, "highest", range.highest);
  read(*found, "count", range.count);
}

PosteriorTrack posterior_track_in(const json& object, const Dimension& dimension,
                                  const DiscriminationDesign& design) {
  PosteriorTrack track{.grid = dimension.grid.value_or(LevelGrid{}),
                       .origin = dimension.level_of_standard()};
  track.prior.thresholds = thresholds_within(track.grid, track.origin);
  track.prior.guess_rate = design.guess_rate();
  track.prior.performance = 0.5 * (1.0 + track.prior.guess_rate);
  read(object, "target", track.prior.performance);
  if (const auto prior = object.find("prior"); prior != object.end()) {
    read_range(*prior, "threshold", track.prior.thresholds);
    read_range(*prior, "slope", track.prior.slopes);
    read_range(*prior, "lapse", track.prior.lapses);
  }
  const auto stop = object.find("stop");
  if (stop == object.end()) return track;
  read(*stop, "trials", track.stop.trials);
  if (const auto interval = stop->find("interval"); interval != stop->end()) {
    IntervalRule& rule = track.stop.interval.emplace();
    read(*interval, "ratio", rule.ratio);
    read(*interval, "minimum_trials", rule.minimum_trials);
    read(*interval, "minimum_of_each", rule.minimum_of_each);
  }
  return track;
}

std::vector<NuisanceParameter> marginalised_in(const json& object) {
  const auto found = object.find("marginalise");
  if (found == object.end()) return Psi{}.marginalised;
  std::vector<NuisanceParameter> nuisances{};
  for (const json& name : *found) {
    nuisances.push_back(name == "slope" ? NuisanceParameter::slope : NuisanceParameter::lapse);
  }
  return nuisances;
}

StopRules stop_rules_of(const json& object) {
  StopRules stop{};
  const auto found = object.find("stop");
  if (found == object.end()) return stop;
  read(*found, "trials", stop.trials);
  read(*found, "reversals", stop.reversals);
  read(*found, "clipped_moves", stop.clipped_moves);
  return stop;
}

External external_in(const json& object, const Dimension& dimension) {
  External settings{};
  if (has_levels(dimension)) settings.levels = dimension.levels();
  if (const auto stop = object.find("stop"); stop != object.end()) {
    read(*stop, "trials", settings.trials);
  }
  if (const auto stated = object.find("settings"); stated != object.end()) {
    settings.settings_json = stated->dump();
  }
  read(object, "answer_within_s", settings.answer_within_s);
  return settings;
}

/// The steps of one direction: those of this direction, or those of both.
StepList steps_of(const json& object, const char* direction) {
  StepList steps{};
  read(object, "steps", steps);
  read(object, direction, steps);
  return steps;
}

ProcedureSettings settings_of(const json& object, const json& track, const Dimension& dimension,
                              const DiscriminationDesign& design) {
  const LevelGrid grid = dimension.grid.value_or(LevelGrid{});
  double start = 0.0;
  read(object, "start", start);
  read(track, "start", start);
  const auto method = object.at("method").get<std::string>();
  if (method == transformed_up_down().id) {
    UpDownTrack settings{.grid = grid,
                         .start = start,
                         .steps_up = steps_of(object, "steps_up"),
                         .steps_down = steps_of(object, "steps_down"),
                         .stop = stop_rules_of(object)};
    read(object, "down", settings.rule.down);
    read(object, "up", settings.rule.up);
    return TransformedUpDown{std::move(settings)};
  }
  if (method == weighted_up_down().id) {
    WeightedUpDown settings{.grid = grid,
                            .start = start,
                            .steps_down = steps_of(object, "steps_down"),
                            .stop = stop_rules_of(object)};
    read(object, "target", settings.target);
    return settings;
  }
  if (method == psi().id) {
    return Psi{.track = posterior_track_in(object, dimension, design),
               .marginalised = marginalised_in(object)};
  }
  if (method == external().id) return external_in(object, dimension);
  if (method == quest_plus().id) {
    return QuestPlus{.track = posterior_track_in(object, dimension, design)};
  }
  ConstantStimuli settings{};
  if (has_levels(dimension)) settings.levels = dimension.levels();
  read(object, "repetitions", settings.repetitions);
  return settings;
}

}  // namespace

Dimension dimension_in(const json& object) {
  Dimension dimension{};
  read(object, "parameter", dimension.parameter);
  dimension.factor = dimension.parameter;
  read(object, "factor", dimension.factor);
  read(object, "of", dimension.role);
  read(object, "relative_to", dimension.standard_role);
  for (const LevelMeasure measure :
       {LevelMeasure::value, LevelMeasure::difference, LevelMeasure::percent, LevelMeasure::ratio,
        LevelMeasure::decibels}) {
    const auto found = object.find(key_of(measure));
    if (found == object.end()) continue;
    dimension.measure = measure;
    if (found->is_object()) {
      dimension.grid = grid_of(*found);
    } else {
      dimension.list = found->get<std::vector<double>>();
    }
  }
  return dimension;
}

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
  dimension.meaning = parameter->meaning;
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
  Block::LevelProcedure procedure{};
  if (const auto tracks = object.find("tracks"); tracks != object.end()) {
    for (const json& track : *tracks) {
      procedure.tracks.push_back(settings_of(object, track, dimension, design));
    }
  } else {
    procedure.tracks.push_back(settings_of(object, json::object(), dimension, design));
  }
  read_choice(object, "timed_out", procedure.timeouts_are_incorrect,
              {{"same_level", false}, {"incorrect", true}});
  if (const auto found = object.find("catch_trials"); found != object.end()) {
    procedure.catch_trials.emplace();
    read_choice(*found, "type", procedure.catch_trials->type,
                {{"easy", CatchType::easy},
                 {"no_signal", CatchType::no_signal},
                 {"identical_pair", CatchType::identical_pair}});
    if (procedure.catch_trials->type != CatchType::easy && dimension.standard) {
      procedure.catch_trials->level = dimension.level_of_standard();
    }
    read(*found, "level", procedure.catch_trials->level);
    read(*found, "every", procedure.catch_trials->every);
  }
  return procedure;
}

}  // namespace asperity
