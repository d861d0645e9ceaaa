// The effects that a power analysis is to find, as stated on the command line.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/power/assumption.h"

namespace asperity {

/// An effect with the values for which power is computed. A name can be the end of several (`is_named`): it states them all.
struct StatedEffect {
  std::string name{};
  std::vector<std::optional<double>> values{};  ///< nothing: the value without an effect, "null"
};

/// Reads "NAME=VALUE[,VALUE…]" with numbers and `null`. Errors: std::invalid_argument with the correct form.
StatedEffect stated_effect_in(const std::string& text);

/// The assumptions with one combination of stated effects.
struct EffectLevel {
  std::string text{};  ///< "comparisons.rougher.slope=0.8"; several separated by ", "
  std::vector<Assumption> assumptions{};
  std::vector<std::string> stated{};  ///< full names
  bool is_null = false;  ///< every effect of the protocol has its value without an effect
};

/// A level for each value of the stated effects. Without stated effects one level: the assumptions unchanged, whose text has all
/// effects with a value. `source`: where the stated values are from.
///
/// Errors: std::invalid_argument for a name that is not an effect of the protocol (with those that are), an effect that is stated
/// twice, and more than one effect with several values.
std::vector<EffectLevel> effect_levels(const std::vector<Assumption>& assumptions,
                                       const std::vector<StatedEffect>& stated,
                                       const std::string& source);

/// The assumptions without the values and sources of the stated effects: what the levels have in common.
std::vector<Assumption> without_stated(std::vector<Assumption> assumptions,
                                       const std::vector<StatedEffect>& stated);

}  // namespace asperity
