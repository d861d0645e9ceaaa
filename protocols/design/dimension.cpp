// Implements the measures of levels.

#include "protocols/design/dimension.h"

#include <algorithm>
#include <cmath>

#include "analysis/numbers/rounded_text.h"

namespace asperity {

// 50 µm + 50 % is stored as 7.5e-05, not as 7.500000000000001e-05.
double value_at(LevelMeasure measure, double level, double standard) {
  switch (measure) {
    case LevelMeasure::value:
      break;
    case LevelMeasure::difference:
      return without_rounding_errors(standard + level);
    case LevelMeasure::percent:
      return without_rounding_errors(standard + standard * level / 100.0);
    case LevelMeasure::ratio:
      return without_rounding_errors(standard * level);
    case LevelMeasure::decibels:
      return without_rounding_errors(standard * std::pow(10.0, level / 20.0));
  }
  return level;
}

double level_at_value(LevelMeasure measure, double value, double standard) {
  switch (measure) {
    case LevelMeasure::value:
      break;
    case LevelMeasure::difference:
      return value - standard;
    case LevelMeasure::percent:
      return 100.0 * (value - standard) / standard;
    case LevelMeasure::ratio:
      return value / standard;
    case LevelMeasure::decibels:
      return 20.0 * std::log10(value / standard);
  }
  return value;
}

bool is_relative(LevelMeasure measure) noexcept { return measure != LevelMeasure::value; }

bool needs_positive_standard(LevelMeasure measure) noexcept {
  return measure != LevelMeasure::value && measure != LevelMeasure::difference;
}

std::string_view key_of(LevelMeasure measure) noexcept {
  switch (measure) {
    case LevelMeasure::value:
      break;
    case LevelMeasure::difference:
      return "levels_difference";
    case LevelMeasure::percent:
      return "levels_percent";
    case LevelMeasure::ratio:
      return "levels_ratio";
    case LevelMeasure::decibels:
      return "levels_decibels";
  }
  return "levels";
}

double Dimension::level_of_standard() const {
  switch (measure) {
    case LevelMeasure::value:
      return standard.value_or(0.0);
    case LevelMeasure::ratio:
      return 1.0;
    case LevelMeasure::difference:
    case LevelMeasure::percent:
    case LevelMeasure::decibels:
      break;
  }
  return 0.0;
}

std::vector<double> Dimension::levels() const {
  std::vector<double> all = list;
  if (grid) {
    ProcedureProblems problems{};
    check_grid(*grid, "", problems);
    all = problems.empty() ? levels_of(*grid) : std::vector<double>{};
  }
  std::sort(all.begin(), all.end());
  return all;
}

std::vector<double> Dimension::values() const {
  std::vector<double> all = levels();
  for (double& level : all) level = value_of(level);
  return all;
}

bool has_levels(const Dimension& dimension) { return !dimension.levels().empty(); }

}  // namespace asperity
