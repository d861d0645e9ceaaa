// The scale on which the level of a stimulus changes in steps.

#pragma once

#include <string_view>

namespace asperity {

/// What a step of size s does to a level x, upwards and downwards:
///
///   linear   x ± s                s has the unit of x
///   log10    x · 10^{±s}          s in log10 units
///   decibel  x · 10^{±s/20}       s in dB, of an amplitude
///   ratio    x · s^{±1}           s > 1
///
/// On all scales but the linear one a level is above 0.
enum class LevelScale { linear, log10, decibel, ratio };

/// A number of steps of one size; negative: downwards. The number need not be whole.
struct LevelMove {
  double size = 0.0;
  double steps = 0.0;
};

/// The level after a move. By the formulas above with one rounding each, so that levels can be computed again
/// elsewhere with the same digits.
double moved_level(LevelScale scale, double level, const LevelMove& move);

/// The place of a level on an axis on which equal steps have equal lengths: x, or log10 x. Levels are averaged there.
double place_on(LevelScale scale, double level);
double level_at(LevelScale scale, double place);  ///< the inverse
/// The length of a step on this axis: above 0 for every valid step.
double step_length(LevelScale scale, double step);

std::string_view name_of(
    LevelScale scale) noexcept;  ///< as in files: "linear", "log10", "db", "ratio"

}  // namespace asperity
