// Implements the checks of the parameter that the trials of a block vary.

#include <algorithm>
#include <cmath>

#include "analysis/numbers/rounded_text.h"
#include "protocols/file/meaning/meaning_checks.h"

namespace asperity {

using Block = Protocol::Block;

namespace {

std::size_t count_of_role(const Block& block, const std::string& role) {
  return static_cast<std::size_t>(
      std::count_if(block.presented.begin(), block.presented.end(),
                    [&role](const auto& each) { return each.role == role; }));
}

std::vector<std::string> roles_in(const Block& block) {
  std::vector<std::string> roles{};
  for (const Protocol::Presented& presented : block.presented) roles.push_back(presented.role);
  return roles;
}

std::string levels_at(const Dimension& dimension, const std::string& pointer) {
  return pointer + "/vary/" + std::string(key_of(dimension.measure));
}

/// A sentence goes on after it.
std::string without_stop(std::string sentence) {
  if (sentence.ends_with('.')) sentence.pop_back();
  return sentence;
}

/// "; as "levels_percent" the limits are -100 and 9900"; empty where levels are values themselves.
std::string limits_as_levels(const Dimension& dimension, const Parameter& declared) {
  if (!is_relative(dimension.measure) || declared.kind == ParameterKind::choice) return {};
  const double least = dimension.level_of(declared.minimum);
  const double greatest = dimension.level_of(declared.maximum);
  if (!std::isfinite(least) || !std::isfinite(greatest)) return {};
  return "; as " + in_quotes(key_of(dimension.measure)) + " the limits are " + rounded_text(least) +
         " and " + rounded_text(greatest);
}

/// Whether all force models of the varied surface have the parameter.
bool check_parameter(CheckedDocument& checked, const Block& block, const std::string& pointer) {
  const Dimension& dimension = *block.vary;
  const auto presented =
      std::find_if(block.presented.begin(), block.presented.end(),
                   [&dimension](const auto& each) { return each.role == dimension.role; });
  const auto stimulus = checked.protocol.stimuli.find(presented->stimulus);
  if (stimulus == checked.protocol.stimuli.end() || dimension.is_relative_amplitude()) return true;
  bool all_have_it = true;
  for (const auto& [id, place] : texts_of(checked, stimulus->second.model,
                                          pointer_to("/stimuli", stimulus->first) + "/model")) {
    const auto model = checked.models.find(id);
    if (model == checked.models.end()) continue;  // reported at its own location
    std::map<std::string, int> names{};
    for (const Parameter& each : model->second->parameters) {
      if (each.kind != ParameterKind::choice) names[each.name] = 0;
    }
    if (names.contains(dimension.parameter)) continue;
    all_have_it = false;
    checked.report(pointer + "/vary/parameter",
                   "the model " + in_quotes(id) + ": " +
                       unknown_name("numeric parameter", dimension.parameter, names));
  }
  return all_have_it;
}

/// The surface to which levels refer. False where the values of the levels cannot be computed.
bool check_standard(CheckedDocument& checked, const Block& block, const std::string& pointer) {
  const Dimension& dimension = *block.vary;
  const std::string place = pointer + "/vary";
  if (!dimension.standard_role.empty() && (dimension.standard_role == dimension.role ||
                                           count_of_role(block, dimension.standard_role) != 1)) {
    checked.report(place + "/relative_to",
                   "no other surface of the block has the role " +
                       in_quotes(dimension.standard_role) +
                       "; state the role of the surface to which levels refer");
    return false;
  }
  if (!is_relative(dimension.measure)) return true;
  const std::string key(key_of(dimension.measure));
  if (dimension.standard_role.empty()) {
    checked.report_key(levels_at(dimension, pointer),
                       in_quotes(key) +
                           " needs a standard; add \"relative_to\" with the role of the "
                           "surface to which the levels refer");
    return false;
  }
  if (!dimension.standard) {
    checked.report(place + "/relative_to", "the stimulus of the " + dimension.standard_role +
                                               " does not state a number for " +
                                               in_quotes(dimension.parameter) +
                                               ", to which the levels refer; state it there");
    return false;
  }
  if (needs_positive_standard(dimension.measure) && !(*dimension.standard > 0.0)) {
    checked.report_key(levels_at(dimension, pointer),
                       "the standard is " + digits(*dimension.standard) + ", and " +
                           in_quotes(key) +
                           " needs a standard above 0; use \"levels\" or \"levels_difference\"");
    return false;
  }
  return true;
}

void check_values(CheckedDocument& checked, const Block& block, const std::string& pointer) {
  const Dimension& dimension = *block.vary;
  const std::string at_levels = levels_at(dimension, pointer);
  const std::string at_parameter = pointer + "/vary/parameter";
  if (dimension.grid) {
    ProcedureProblems problems{};
    check_grid(*dimension.grid, "", problems);
    for (const ProcedureProblem& problem : problems.all()) {
      checked.report(at_levels + "/" + problem.setting, problem.message);
    }
    if (!problems.empty()) return;
    if (size_of(*dimension.grid) > kMaximumTrials) {
      checked.report(at_levels + "/step",
                     "the grid has " + std::to_string(size_of(*dimension.grid)) +
                         " levels, and every level is checked before a session; use "
                         "a larger step or a narrower range");
      return;
    }
  }
  const std::vector<double> levels = dimension.levels();
  if (std::adjacent_find(levels.begin(), levels.end()) != levels.end()) {
    checked.report(at_levels, "a level is stated twice; state each level once");
  }
  const auto presented =
      std::find_if(block.presented.begin(), block.presented.end(),
                   [&dimension](const auto& each) { return each.role == dimension.role; });
  const auto stimulus = checked.protocol.stimuli.find(presented->stimulus);
  if (stimulus == checked.protocol.stimuli.end()) return;  // reported at its own location
  if (dimension.is_relative_amplitude()) {
    check_relative_amplitude(checked, block, stimulus->second, pointer);
    return;
  }
  const auto bound = stimulus->second.parameters.find(dimension.parameter);
  if (bound != stimulus->second.parameters.end() && !bound->second.factor.empty()) {
    checked.report(at_parameter, "the stimulus " + in_quotes(presented->stimulus) +
                                     " binds this parameter to the factor " +
                                     in_quotes(bound->second.factor) +
                                     "; state a number there, or present another stimulus");
    return;
  }
  for (const auto& [id, place] : texts_of(checked, stimulus->second.model,
                                          pointer_to("/stimuli", stimulus->first) + "/model")) {
    const auto model = checked.models.find(id);
    if (model == checked.models.end()) continue;  // reported at its own location
    const std::vector<Parameter>& parameters = model->second->parameters;
    const auto declared =
        std::find_if(parameters.begin(), parameters.end(), [&dimension](const Parameter& each) {
          return each.name == dimension.parameter && each.kind != ParameterKind::choice;
        });
    if (declared == parameters.end()) continue;  // check_parameter
    if (stimulus->second.equal_force && model->second->amplitude_parameter == dimension.parameter) {
      checked.report(at_parameter,
                     "equal_force of the stimulus " + in_quotes(presented->stimulus) +
                         " determines this parameter; remove it there, or vary another "
                         "parameter");
    }
    const auto check_level = [&](double level, const std::string& at) {
      const double value = dimension.value_of(level);
      const auto complaint = complaint_about(*declared, value);
      if (complaint) {
        checked.report(at, "the level " + rounded_text(level) + " is a value of " +
                               rounded_text(value) + ": " + without_stop(*complaint) +
                               limits_as_levels(dimension, *declared));
      }
    };
    if (dimension
            .grid) {  // its values are in order: the limits are exceeded at its ends, if at all
      check_level(levels.front(), at_levels + "/lowest");
      if (levels.size() > 1) check_level(levels.back(), at_levels + "/highest");
    }
    for (std::size_t i = 0; i < dimension.list.size(); ++i) {
      check_level(dimension.list[i], pointer_to(at_levels, i));
    }
    if (block.procedure && block.procedure->catch_trials) {
      check_level(block.procedure->catch_trials->level, pointer + "/procedure/catch_trials/level");
    }
    if (const auto anchor = block.anchor.find(dimension.factor); anchor != block.anchor.end()) {
      if (const auto* const level = std::get_if<double>(&anchor->second)) {
        check_level(*level, pointer_to(pointer + "/anchor", dimension.factor));
      }
    }
  }
}

}  // namespace

void check_dimension(CheckedDocument& checked, const Block& block, const std::string& pointer) {
  if (!block.vary) return;
  const Dimension& dimension = *block.vary;
  const std::string place = pointer + "/vary";
  const auto& stated = checked.document.root().at("blocks").at(block.name).at("vary");
  const auto factors = checked.document.root().find("factors");
  if (factors != checked.document.root().end() && factors->contains(dimension.factor)) {
    checked.report(
        place + (stated.contains("factor") ? "/factor" : "/parameter"),
        "the factor " + in_quotes(dimension.factor) +
            " is already declared under /factors; state another name as \"factor\" here, or "
            "remove that factor");
    return;
  }
  for (const auto& [name, other] : checked.protocol.blocks) {
    if (name == block.name || !other.vary || other.vary->factor != dimension.factor ||
        other.vary->parameter == dimension.parameter) {
      continue;
    }
    checked.report(place + (stated.contains("factor") ? "/factor" : "/parameter"),
                   "the block " + in_quotes(name) + " varies the parameter " +
                       in_quotes(other.vary->parameter) + " under the name " +
                       in_quotes(dimension.factor) +
                       "; state another name as \"factor\" in one of them");
    return;
  }
  if (count_of_role(block, dimension.role) != 1) {
    checked.report(place + "/of",
                   std::to_string(count_of_role(block, dimension.role)) +
                       " surfaces of the block have the role " + in_quotes(dimension.role) +
                       "; state the role of exactly one: " + one_of(roles_in(block)));
    return;
  }
  if (check_parameter(checked, block, pointer) && check_standard(checked, block, pointer)) {
    check_values(checked, block, pointer);
  }
}

}  // namespace asperity
