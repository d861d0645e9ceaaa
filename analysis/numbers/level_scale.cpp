// Moves levels by sums on the linear scale and by powers on the others, whose common place is log10.

#include "analysis/numbers/level_scale.h"

#include <cmath>

namespace asperity {

double moved_level(LevelScale scale, double level, const LevelMove& move) {
  switch (scale) {
    case LevelScale::linear:
      return level + move.steps * move.size;
    case LevelScale::log10:
      return level * std::pow(10.0, move.steps * move.size);
    case LevelScale::decibel:
      return level * std::pow(10.0, move.steps * move.size / 20.0);
    case LevelScale::ratio:
      return level * std::pow(move.size, move.steps);
  }
  return level;
}

double place_on(LevelScale scale, double level) {
  return scale == LevelScale::linear ? level : std::log10(level);
}

double level_at(LevelScale scale, double place) {
  return scale == LevelScale::linear ? place : std::pow(10.0, place);
}

double step_length(LevelScale scale, double step) {
  switch (scale) {
    case LevelScale::linear:
    case LevelScale::log10:
      return step;
    case LevelScale::decibel:
      return step / 20.0;
    case LevelScale::ratio:
      return std::log10(step);
  }
  return step;
}

std::string_view name_of(LevelScale scale) noexcept {
  switch (scale) {
    case LevelScale::linear:
      return "linear";
    case LevelScale::log10:
      return "log10";
    case LevelScale::decibel:
      return "db";
    case LevelScale::ratio:
      return "ratio";
  }
  return "";
}

}  // namespace asperity
