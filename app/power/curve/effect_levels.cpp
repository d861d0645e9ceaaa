// Parses the stated effects, finds each by its name, and makes the assumptions for every level.

#include "app/power/curve/effect_levels.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <stdexcept>

#include "analysis/numbers/number_text.h"
#include "app/words/text_parts.h"
#include "results_schema/tables/table.h"

namespace asperity {

namespace {

constexpr const char* kNull = "null";

/// A name can be that of the same effect of several questions.
std::vector<Assumption*> effects_named(std::vector<Assumption>& assumptions,
                                       const std::string& name) {
  std::vector<Assumption*> effects{};
  for (Assumption& one : assumptions) {
    if (one.part == Assumption::Part::effect && is_named(one, name)) effects.push_back(&one);
  }
  return effects;
}

/// "comparisons.rougher.slope (log-odds), …"
std::string known_effects(const std::vector<Assumption>& assumptions) {
  std::vector<std::string> names{};
  for (const Assumption& one : assumptions) {
    if (one.part != Assumption::Part::effect) continue;
    names.push_back(one.name + (one.unit.empty() || one.unit == "1" ? "" : " (" + one.unit + ')'));
  }
  return names.empty() ? "it has none" : "its effects are " + listed(names);
}

void require_stated(std::vector<Assumption> assumptions, const std::vector<StatedEffect>& stated) {
  std::size_t with_several = 0;
  std::set<const Assumption*> met{};
  for (const StatedEffect& effect : stated) {
    const std::vector<Assumption*> effects = effects_named(assumptions, effect.name);
    if (effects.empty()) {
      throw std::invalid_argument(effect.name + " is not an effect of the protocol; " +
                                  known_effects(assumptions));
    }
    for (const Assumption* one : effects) {
      if (met.insert(one).second) continue;
      throw std::invalid_argument(one->name + " is stated twice; write its values in one list, " +
                                  one->name + "=VALUE,VALUE");
    }
    if (effect.values.size() > 1) ++with_several;
  }
  if (with_several > 1) {
    throw std::invalid_argument(
        "several effects have more than one value; state one value for each but one of them, and "
        "repeat the command for the other combinations");
  }
}

std::string level_text(const std::string& name, double value) {
  return name + '=' + number_text(value);
}

}  // namespace

StatedEffect stated_effect_in(const std::string& text) {
  const std::size_t equals = text.find('=');
  const std::string expected =
      '"' + text +
      "\" is not an effect with its values; write NAME=VALUE or NAME=VALUE,VALUE,… with "
      "numbers or the word null, such as comparisons.rougher.slope=0.5,1";
  if (equals == std::string::npos || equals == 0) throw std::invalid_argument(expected);
  StatedEffect effect{.name = text.substr(0, equals)};
  for (const std::string& part : parts_of(text.substr(equals + 1), ',')) {
    std::optional<double> value{};
    if (part != kNull) {
      value = number_in(part);
      if (!value || !std::isfinite(*value)) throw std::invalid_argument(expected);
    }
    effect.values.push_back(value);
  }
  return effect;
}

std::vector<EffectLevel> effect_levels(const std::vector<Assumption>& assumptions,
                                       const std::vector<StatedEffect>& stated,
                                       const std::string& source) {
  require_stated(assumptions, stated);
  std::size_t levels = 1;
  for (const StatedEffect& effect : stated) levels = std::max(levels, effect.values.size());
  std::vector<EffectLevel> all{};
  for (std::size_t i = 0; i < levels; ++i) {
    EffectLevel& level = all.emplace_back(EffectLevel{.assumptions = assumptions});
    std::vector<std::string> texts{};
    for (const StatedEffect& effect : stated) {
      const std::optional<double>& value = effect.values[effect.values.size() > 1 ? i : 0];
      for (Assumption* assumed : effects_named(level.assumptions, effect.name)) {
        assumed->value = value.value_or(assumed->null_value);
        assumed->source = value ? source : kNoEffect;
        level.stated.push_back(assumed->name);
        texts.push_back(level_text(assumed->name, *assumed->value));
      }
    }
    level.is_null = true;
    for (const Assumption& one : level.assumptions) {
      if (one.part != Assumption::Part::effect) continue;
      level.is_null = level.is_null && one.value == one.null_value;
      if (stated.empty() && one.value) texts.push_back(level_text(one.name, *one.value));
    }
    level.text = comma_separated(texts);
  }
  return all;
}

std::vector<Assumption> without_stated(std::vector<Assumption> assumptions,
                                       const std::vector<StatedEffect>& stated) {
  require_stated(assumptions, stated);
  for (const StatedEffect& effect : stated) {
    for (Assumption* assumed : effects_named(assumptions, effect.name)) {
      assumed->value.reset();
      assumed->source.clear();
    }
  }
  return assumptions;
}

}  // namespace asperity
