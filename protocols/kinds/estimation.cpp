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
        problems.report(place,
                        phrase("Protocols", "a spacing must be above 0; write a length in metres"));
      continue;
    }
    const auto texture = protocol.textures.find(text_of(levels[i]));
    if (texture == protocol.textures.end()) {
      problems.report(place, phrase("Protocols",
                                    "%1 is used as a spacing but is neither a number nor a "
                                    "texture; write a length in metres, or the name of a texture")
                                 .with(in_quotes(text_of(levels[i]))));
    } else if (!texture->second.spacing_m) {
      problems.report(
          pointer_to("/textures", texture->first),
          phrase("Protocols", "estimates are analysed by the spacing of this texture: give it a %1")
              .with(key_name("spacing_m")));
    }
  }
  std::set<double> spacings{};
  for (const auto& [level, spacing_m] : protocol.estimation->spacing_m) spacings.insert(spacing_m);
  if (spacings.size() < kLevelsOfCurve) {
    problems.report(
        at_levels,
        phrase("Protocols",
               "a curve needs at least three different spacings; number given: %1; add spacings")
            .with(std::to_string(spacings.size())));
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
  problems.report(
      place,
      (needed == kLevelsOfCurve
           ? phrase("Protocols",
                    "an exponent needs at least three different values of the predictor; number "
                    "given: %1; add levels")
           : phrase(
                 "Protocols",
                 "estimates of at least two stimuli can be compared; number given: %1; add levels"))
          .with(std::to_string(different)));
}

void check_values(const Protocol& protocol, const std::vector<Level>& levels,
                  ProblemSink& problems) {
  const auto& values = protocol.estimation->predictor_values;
  std::set<std::string> names{};
  std::set<double> different{};
  for (const Level& level : levels) {
    names.insert(text_of(level));
    if (!values.contains(text_of(level))) {
      problems.report("/estimation/values",
                      phrase("Protocols", "the level %1 of the factor has no value; add it")
                          .with(in_quotes(text_of(level))));
    }
  }
  for (const auto& [level, value] : values) {
    const std::string place = pointer_to("/estimation/values", level);
    if (!names.contains(level)) {
      problems.report(place, phrase("Protocols", "%1 is not a level of the factor %2; remove it")
                                 .with(in_quotes(level), in_quotes(protocol.estimation->items)));
    }
    if (!(value > 0.0)) {
      problems.report(
          place,
          phrase("Protocols",
                 "the value is %1; it must be above 0, because its logarithm is the abscissa")
              .with(number_text(value)));
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
      problems.report(
          at_levels,
          phrase("Protocols",
                 "the predictor is the level, and %1 is not a number above 0; set %2 to %3 and "
                 "state the value of each level, or write numbers above 0")
              .with(in_quotes(text_of(level)), key_name("predictor"), word_name("values")));
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
                    phrase("Protocols",
                           "write exactly one of %1, the factor whose levels are spacings, and %2, "
                           "the factor whose levels are any other stimuli")
                        .with(key_name("spacing"), key_name("factor")));
  }
  if (estimation.items.empty() && !estimation.predictor.empty()) {
    problems.report(
        "/estimation/predictor",
        phrase("Protocols",
               "the predictor is the spacing; remove this key, or write %1 in place of %2")
            .with(key_name("factor"), key_name("spacing")));
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
                      phrase("Protocols", "this test belongs to an estimation with %1; write %2")
                          .with(key_name(test->estimated_by), joined_by_or(quoted(tests))));
    } else if (test->name == "exponent" && estimation.predictor.empty()) {
      problems.report(pointer_to("/analysis/family", i),
                      phrase("Protocols",
                             "without a predictor there is no exponent; state a %1 under "
                             "%2, or remove this test")
                          .with(key_name("predictor"), place_name("/estimation")));
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
                    phrase("Protocols",
                           "with free modulus every participant has a separate scale, which only "
                           "%1 removes; write it, or state a standard with its number under %2")
                        .with(word_name("geometric_mean"), key_name("modulus")));
    return;
  }
  const auto factor = protocol.factors.find(estimation.factor());
  if (factor == protocol.factors.end()) {
    problems.report(
        "/estimation/modulus/standard",
        phrase("Protocols",
               "a standard is a level of a factor under %1, and %2 is not one; declare "
               "it there, or set the modulus to %3")
            .with(place_name("/factors"), in_quotes(estimation.factor()), word_name("free")));
    return;
  }
  const std::vector<Level>& levels = factor->second.levels;
  const bool is_level = std::any_of(levels.begin(), levels.end(), [&](const Level& level) {
    return text_of(level) == estimation.modulus->standard;
  });
  if (!is_level) {
    problems.report(
        "/estimation/modulus/standard",
        phrase("Protocols", "%1 is not a level of the factor %2; write one of its levels")
            .with(in_quotes(estimation.modulus->standard), in_quotes(estimation.factor())));
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
        (estimation.spacing.empty()
             ? phrase("Protocols",
                      "a main block must cross, list or vary the levels of the factor %1")
             : phrase("Protocols", "a main block must cross or list the spacings, the factor %1"))
            .with(in_quotes(factor)));
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
    problems.report(pointer, phrase("Protocols",
                                    "the condition must be constant within a block: run this block "
                                    "%1 level of %2 instead of mixing the levels")
                                 .with(key_name("for_each"), in_quotes(estimation.condition)));
    return;
  }
  for (const Protocol::Run* const run : runs_of(protocol, block)) {
    if (factors_set_by(block, run).contains(estimation.condition)) continue;
    problems.report(pointer, phrase("Protocols",
                                    "this main block does not set the condition %1: run the block "
                                    "%2 level of the condition")
                                 .with(in_quotes(estimation.condition), key_name("for_each")));
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
    problems.report(
        "/estimation/condition",
        estimation.spacing.empty()
            ? phrase("Protocols",
                     "the items and the condition are the same factor; name another one")
            : phrase("Protocols", "spacing and condition are the same factor; name another one"));
    return;
  }
  for (const auto& [name, block] : protocol.blocks) {
    if (block.phase != Phase::main || block.kind != "magnitude") continue;
    check_design_of(protocol, block, has_spacing || has_items, has_condition, problems);
  }
}

}  // namespace asperity
