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

/// "; as "levels_percent" the limits are -100 and 9900"; empty where levels are values themselves.
Phrase limits_as_levels(const Dimension& dimension, const Parameter& declared) {
  if (!is_relative(dimension.measure) || declared.kind == ParameterKind::choice) return {};
  const double least = dimension.level_of(declared.minimum);
  const double greatest = dimension.level_of(declared.maximum);
  if (!std::isfinite(least) || !std::isfinite(greatest)) return {};
  return phrase("Protocols", "; as %1 the limits are %2 and %3")
      .with(key_name(key_of(dimension.measure)), rounded_text(least), rounded_text(greatest));
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
    checked.report(
        pointer + "/vary/parameter",
        phrase("Protocols", "the model %1: %2")
            .with(in_quotes(id), unknown_name("numeric parameter", dimension.parameter, names)));
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
                   phrase("Protocols",
                          "no other surface of the block has the role %1; state the role of the "
                          "surface to which levels refer")
                       .with(in_quotes(dimension.standard_role)));
    return false;
  }
  if (!is_relative(dimension.measure)) return true;
  const Phrase key = key_name(key_of(dimension.measure));
  if (dimension.standard_role.empty()) {
    checked.report_key(levels_at(dimension, pointer),
                       phrase("Protocols",
                              "%1 needs a standard; add %2 with the role of the surface to which "
                              "the levels refer")
                           .with(key, key_name("relative_to")));
    return false;
  }
  if (!dimension.standard) {
    checked.report(place + "/relative_to",
                   phrase("Protocols",
                          "the stimulus of the %1 does not state a number for %2, to which the "
                          "levels refer; state it there")
                       .with(dimension.standard_role, in_quotes(dimension.parameter)));
    return false;
  }
  if (needs_positive_standard(dimension.measure) && !(*dimension.standard > 0.0)) {
    checked.report_key(
        levels_at(dimension, pointer),
        phrase("Protocols", "the standard is %1, and %2 needs a standard above 0; use %3 or %4")
            .with(digits(*dimension.standard), key, key_name("levels"),
                  key_name("levels_difference")));
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
                     phrase("Protocols",
                            "the grid has %1 levels, and every level is checked before a session; "
                            "use a larger step or a narrower range")
                         .with(std::to_string(size_of(*dimension.grid))));
      return;
    }
  }
  const std::vector<double> levels = dimension.levels();
  if (std::adjacent_find(levels.begin(), levels.end()) != levels.end()) {
    checked.report(at_levels,
                   phrase("Protocols", "a level is stated twice; state each level once"));
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
    checked.report(at_parameter,
                   phrase("Protocols",
                          "the stimulus %1 binds this parameter to the factor %2; state a number "
                          "there, or present another stimulus")
                       .with(in_quotes(presented->stimulus), in_quotes(bound->second.factor)));
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
                     phrase("Protocols",
                            "%1 of the stimulus %2 determines this parameter; remove it there, or "
                            "vary another parameter")
                         .with(key_name("equal_force"), in_quotes(presented->stimulus)));
    }
    const auto check_level = [&](double level, const std::string& at) {
      const double value = dimension.value_of(level);
      const auto complaint = problem_of_value(*declared, value);
      if (complaint) {
        checked.report(at, phrase("Protocols", "the level %1 is a value of %2: %3%4")
                               .with(rounded_text(level), rounded_text(value), *complaint,
                                     limits_as_levels(dimension, *declared)));
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
        phrase("Protocols",
               "the factor %1 is already declared under %2; state another name as %3 here, or "
               "remove that factor")
            .with(in_quotes(dimension.factor), place_name("/factors"), key_name("factor")));
    return;
  }
  for (const auto& [name, other] : checked.protocol.blocks) {
    if (name == block.name || !other.vary || other.vary->factor != dimension.factor ||
        other.vary->parameter == dimension.parameter) {
      continue;
    }
    checked.report(place + (stated.contains("factor") ? "/factor" : "/parameter"),
                   phrase("Protocols",
                          "the block %1 varies the parameter %2 under the name %3; state another "
                          "name as %4 in one of them")
                       .with(in_quotes(name), in_quotes(other.vary->parameter),
                             in_quotes(dimension.factor), key_name("factor")));
    return;
  }
  if (count_of_role(block, dimension.role) != 1) {
    checked.report(place + "/of",
                   phrase("Protocols",
                          "%1 surfaces of the block have the role %2; state the role of exactly "
                          "one: %3")
                       .with(std::to_string(count_of_role(block, dimension.role)),
                             in_quotes(dimension.role), joined_by_or(quoted(roles_in(block)))));
    return;
  }
  if (check_parameter(checked, block, pointer) && check_standard(checked, block, pointer)) {
    check_values(checked, block, pointer);
  }
}

}  // namespace asperity
