// The checks of the key "estimation".

#include "protocols/kinds/estimation.h"

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <variant>

#include "analysis/numbers/number_text.h"
#include "protocols/design/block_factors.h"
#include "protocols/design/json_pointer.h"
#include "protocols/design/wording.h"
#include "protocols/kinds/experiment_kind.h"
#include "protocols/kinds/kind_list.h"

namespace asperity {

namespace {

void check_spacings(const Protocol& protocol, const std::string& factor, ProblemSink& problems) {
  const std::string at_levels = pointer_to("/factors", factor) + "/levels";
  const std::vector<Level>& levels = protocol.factors.at(factor).levels;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const std::string place = pointer_to(at_levels, i);
    if (const double* const spacing_m = std::get_if<double>(&levels[i])) {
      if (*spacing_m <= 0.0)
        problems.report(place, "a spacing must be above 0; write a length in metres");
      continue;
    }
    const auto texture = protocol.textures.find(text_of(levels[i]));
    if (texture == protocol.textures.end()) {
      problems.report(place,
                      in_quotes(text_of(levels[i])) +
                          " is used as a spacing but is neither a number nor a texture; write "
                          "a length in metres, or the name of a texture");
    } else if (!texture->second.spacing_m) {
      problems.report(
          pointer_to("/textures", texture->first),
          "estimates are analysed by the spacing of this texture: give it a \"spacing_m\"");
    }
  }
  std::set<double> spacings{};
  for (const auto& [level, spacing_m] : protocol.estimation->spacing_m) spacings.insert(spacing_m);
  if (spacings.size() < kLevelsOfCurve) {
    problems.report(at_levels, "a curve needs at least three different spacings; number given: " +
                                   std::to_string(spacings.size()) + "; add spacings");
  }
}

/// The levels of the factor that names the items; those of a varied parameter as its blocks state them.
std::vector<Level> levels_of_items(const Protocol& protocol) {
  const auto factor = protocol.factors.find(protocol.estimation->items);
  if (factor != protocol.factors.end()) return factor->second.levels;
  std::vector<Level> levels{};
  for (const auto& [name, block] : protocol.blocks) {
    if (block.phase != Phase::main || !block.vary) continue;
    if (block.vary->factor != protocol.estimation->items) continue;
    for (const double value : block.vary->values()) levels.emplace_back(value);
  }
  return levels;
}

void check_number_of_levels(std::size_t different, std::size_t needed, const std::string& place,
                            ProblemSink& problems) {
  if (different >= needed) return;
  problems.report(place, std::string(needed == kLevelsOfCurve
                                         ? "an exponent needs at least three different values of "
                                           "the predictor; number given: "
                                         : "estimates of at least two stimuli can be compared; "
                                           "number given: ") +
                             std::to_string(different) + "; add levels");
}

void check_values(const Protocol& protocol, const std::vector<Level>& levels,
                  ProblemSink& problems) {
  const auto& values = protocol.estimation->predictor_values;
  std::set<std::string> names{};
  std::set<double> different{};
  for (const Level& level : levels) {
    names.insert(text_of(level));
    if (!values.contains(text_of(level))) {
      problems.report("/estimation/values", "the level " + in_quotes(text_of(level)) +
                                                " of the factor has no value; add it");
    }
  }
  for (const auto& [level, value] : values) {
    const std::string place = pointer_to("/estimation/values", level);
    if (!names.contains(level)) {
      problems.report(place, in_quotes(level) + " is not a level of the factor " +
                                 in_quotes(protocol.estimation->items) + "; remove it");
    }
    if (!(value > 0.0)) {
      problems.report(place, "the value is " + number_text(value) +
                                 "; it must be above 0, because its logarithm is the abscissa");
    }
    different.insert(value);
  }
  check_number_of_levels(different.size(), kLevelsOfCurve, "/estimation/values", problems);
}

void check_items(const Protocol& protocol, ProblemSink& problems) {
  const EstimationDeclaration& estimation = *protocol.estimation;
  const std::vector<Level> levels = levels_of_items(protocol);
  const bool is_varied_one = !protocol.factors.contains(estimation.items);
  const std::string at_levels =
      is_varied_one ? "/estimation/factor" : pointer_to("/factors", estimation.items) + "/levels";
  std::set<Level> different(levels.begin(), levels.end());
  if (estimation.predictor == kValuePredictor) {
    check_values(protocol, levels, problems);
    return;
  }
  if (estimation.predictor == kLevelPredictor) {
    for (const Level& level : levels) {
      const double* const number = std::get_if<double>(&level);
      if (number != nullptr && *number > 0.0) continue;
      problems.report(at_levels,
                      "the predictor is the level, and " + in_quotes(text_of(level)) +
                          " is not a number above 0; set \"predictor\" to \"values\" and state "
                          "the value of each level, or write numbers above 0");
    }
  }
  check_number_of_levels(different.size(), estimation.predictor.empty() ? 2 : kLevelsOfCurve,
                         at_levels, problems);
}

/// Keys of one of the two ways to compare stimuli in a protocol with the other.
void check_way(const Protocol& protocol, ProblemSink& problems) {
  const EstimationDeclaration& estimation = *protocol.estimation;
  if (estimation.spacing.empty() == estimation.items.empty()) {
    problems.report("/estimation",
                    "write exactly one of \"spacing\", the factor whose levels are spacings, and "
                    "\"factor\", the factor whose levels are any other stimuli");
  }
  if (estimation.items.empty() && !estimation.predictor.empty()) {
    problems.report("/estimation/predictor",
                    "the predictor is the spacing; remove this key, or write \"factor\" in place "
                    "of \"spacing\"");
  }
  const std::string_view way = estimation.items.empty() ? kBySpacing : kByFactor;
  std::vector<std::string> tests{};
  for (const KindTest& test : magnitude_kind().tests) {
    if (test.estimated_by == way) tests.emplace_back(test.name);
  }
  const std::vector<std::string>& family = protocol.analysis.family;
  for (std::size_t i = 0; i < family.size(); ++i) {
    const KindTest* const test = find_test(magnitude_kind(), family[i]);
    if (test == nullptr || test->estimated_by.empty()) continue;
    if (test->estimated_by != way) {
      problems.report(pointer_to("/analysis/family", i),
                      "this test belongs to an estimation with " + in_quotes(test->estimated_by) +
                          "; write " + one_of(tests));
    } else if (test->name == "exponent" && estimation.predictor.empty()) {
      problems.report(pointer_to("/analysis/family", i),
                      "without a predictor there is no exponent; state a \"predictor\" under "
                      "/estimation, or remove this test");
    }
  }
}

void check_modulus(const Protocol& protocol, ProblemSink& problems) {
  const EstimationDeclaration& estimation = *protocol.estimation;
  if (!estimation.modulus) {
    if (estimation.stated_normalisation.value_or(EstimateNormalisation::geometric_mean) ==
        EstimateNormalisation::geometric_mean) {
      return;
    }
    problems.report("/estimation/normalisation",
                    "with free modulus every participant has a separate scale, which only "
                    "\"geometric_mean\" removes; write it, or state a standard with its number "
                    "under \"modulus\"");
    return;
  }
  const auto factor = protocol.factors.find(estimation.factor());
  if (factor == protocol.factors.end()) {
    problems.report("/estimation/modulus/standard",
                    "a standard is a level of a factor under /factors, and " +
                        in_quotes(estimation.factor()) +
                        " is not one; declare it there, or set the modulus to \"free\"");
    return;
  }
  const std::vector<Level>& levels = factor->second.levels;
  const bool is_level = std::any_of(levels.begin(), levels.end(), [&](const Level& level) {
    return text_of(level) == estimation.modulus->standard;
  });
  if (!is_level) {
    problems.report("/estimation/modulus/standard",
                    in_quotes(estimation.modulus->standard) + " is not a level of the factor " +
                        in_quotes(estimation.factor()) + "; write one of its levels");
  }
}

/// A main block varies the analysed factor and keeps the condition constant.
void check_design_of(const Protocol& protocol, const Protocol::Block& block, bool has_factor,
                     bool has_condition, ProblemSink& problems) {
  const EstimationDeclaration& estimation = *protocol.estimation;
  const std::string pointer = pointer_to("/blocks", block.name);
  const auto crosses = [&block](const std::string& factor) {
    return std::find(block.crossed.begin(), block.crossed.end(), factor) != block.crossed.end();
  };
  const std::string& factor = estimation.factor();
  const bool lists_it = std::any_of(block.listed.begin(), block.listed.end(),
                                    [&](const auto& row) { return row.contains(factor); });
  const bool varies_it = block.vary && block.vary->factor == factor;
  if (has_factor && !crosses(factor) && !lists_it && !varies_it) {
    problems.report(
        pointer,
        estimation.spacing.empty()
            ? "a main block must cross, list or vary the levels of the factor " + in_quotes(factor)
            : "a main block must cross or list the spacings, the factor " + in_quotes(factor));
  }
  if (!has_condition) return;
  std::set<Level> held{};
  for (const auto& row : block.listed) {
    const auto level = row.find(estimation.condition);
    if (level != row.end()) held.insert(level->second);
  }
  const bool draws =
      std::find(block.drawn.begin(), block.drawn.end(), estimation.condition) != block.drawn.end();
  if (held.size() > 1 || crosses(estimation.condition) || draws) {
    problems.report(pointer,
                    "the condition must be constant within a block: run this block for_each level "
                    "of " +
                        in_quotes(estimation.condition) + " instead of mixing the levels");
    return;
  }
  for (const Protocol::Run* const run : runs_of(protocol, block)) {
    if (factors_set_by(block, run).contains(estimation.condition)) continue;
    problems.report(pointer, "this main block does not set the condition " +
                                 in_quotes(estimation.condition) +
                                 ": run the block for_each level of the condition");
  }
}

}  // namespace

void check_estimation(const Protocol& protocol, ProblemSink& problems) {
  if (!protocol.estimation) return;
  const EstimationDeclaration& estimation = *protocol.estimation;
  check_way(protocol, problems);
  const auto is_known = [&](const std::string& factor, const char* key) {
    if (factor.empty() || protocol.factors.contains(factor)) return !factor.empty();
    problems.report(std::string("/estimation/") + key,
                    unknown_name("factor", factor, protocol.factors));
    return false;
  };
  const bool has_spacing = is_known(estimation.spacing, "spacing");
  const bool has_items = !estimation.items.empty() && (is_varied(protocol, estimation.items) ||
                                                       is_known(estimation.items, "factor"));
  const bool has_condition = is_known(estimation.condition, "condition");
  if (has_spacing) check_spacings(protocol, estimation.spacing, problems);
  if (has_items && !has_spacing) check_items(protocol, problems);
  if (has_spacing || has_items) check_modulus(protocol, problems);
  if (!estimation.condition.empty() && estimation.condition == estimation.factor()) {
    problems.report("/estimation/condition",
                    estimation.spacing.empty()
                        ? "the items and the condition are the same factor; name another one"
                        : "spacing and condition are the same factor; name another one");
    return;
  }
  for (const auto& [name, block] : protocol.blocks) {
    if (block.phase != Phase::main || block.kind != "magnitude") continue;
    check_design_of(protocol, block, has_spacing || has_items, has_condition, problems);
  }
}

}  // namespace asperity
