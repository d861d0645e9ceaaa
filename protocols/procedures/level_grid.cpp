// Converts between levels and indices on a linear or logarithmic scale, with a tolerance for rounding.

#include "protocols/procedures/level_grid.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "analysis/numbers/number_text.h"

namespace asperity {
namespace {

constexpr double kRounding = 1e-6;  // of a grid step

/// The place of a level in grid steps above the lowest.
double steps_above_lowest(const LevelGrid& grid, double level) {
  return (place_on(grid.scale, level) - place_on(grid.scale, grid.lowest)) /
         step_length(grid.scale, grid.step);
}

Phrase least_step(LevelScale scale) {
  return scale == LevelScale::ratio ? phrase("Protocols", "1, such as 1.1 for steps of 10 %") : "0";
}

}  // namespace

void check_grid(const LevelGrid& grid, const std::string& name, ProcedureProblems& problems) {
  const std::string prefix = name.empty() ? "" : name + '.';
  for (const auto& [setting, value] :
       {std::pair{"lowest", grid.lowest}, std::pair{"highest", grid.highest},
        std::pair{"step", grid.step}}) {
    if (std::isfinite(value)) continue;
    problems.report(prefix + setting,
                    phrase("Protocols", "%1 is not a finite number; state one").with(setting));
    return;
  }
  if (!(step_length(grid.scale, grid.step) > 0.0)) {
    problems.report(
        prefix + "step",
        phrase("Protocols",
               "the step %1 does not change the level; on the scale %2 it must be above %3")
            .with(number_text(grid.step), std::string(name_of(grid.scale)),
                  least_step(grid.scale)));
    return;
  }
  if (grid.scale != LevelScale::linear && !(grid.lowest > 0.0)) {
    problems.report(prefix + "lowest",
                    phrase("Protocols",
                           "the lowest level is %1; on the scale %2 levels are above 0: raise it, "
                           "or use the scale linear")
                        .with(number_text(grid.lowest), std::string(name_of(grid.scale))));
    return;
  }
  if (grid.lowest > grid.highest) {
    problems.report(prefix + "highest",
                    phrase("Protocols",
                           "the grid is empty: its highest level %1 is below its lowest %2; "
                           "exchange them, or correct the unit of one of them")
                        .with(number_text(grid.highest), number_text(grid.lowest)));
    return;
  }
  if (steps_above_lowest(grid, grid.highest) >= static_cast<double>(kMostLevels)) {
    problems.report(
        prefix + "step",
        phrase("Protocols",
               "the grid has more than %1 levels; use a larger step or a narrower range")
            .with(std::to_string(kMostLevels)));
  }
}

std::size_t size_of(const LevelGrid& grid) {
  return static_cast<std::size_t>(std::floor(steps_above_lowest(grid, grid.highest) + kRounding)) +
         1;
}

double level_of(const LevelGrid& grid, std::size_t index) {
  return moved_level(grid.scale, grid.lowest,
                     {.size = grid.step, .steps = static_cast<double>(index)});
}

std::vector<double> levels_of(const LevelGrid& grid) {
  std::vector<double> levels(size_of(grid));
  for (std::size_t i = 0; i < levels.size(); ++i) levels[i] = level_of(grid, i);
  return levels;
}

std::size_t nearest_index(const LevelGrid& grid, double level) {
  const double last = static_cast<double>(size_of(grid) - 1);
  const bool has_place = grid.scale == LevelScale::linear || level > 0.0;
  const double steps = has_place ? steps_above_lowest(grid, level) : 0.0;
  return static_cast<std::size_t>(std::round(std::clamp(steps, 0.0, last)));
}

bool is_on(const LevelGrid& grid, double level) {
  if (!std::isfinite(level) || (grid.scale != LevelScale::linear && !(level > 0.0))) return false;
  const double steps = steps_above_lowest(grid, level);
  return std::abs(steps - static_cast<double>(nearest_index(grid, level))) <= kRounding;
}

std::size_t grid_steps(const LevelGrid& grid, double step) {
  const double steps = step_length(grid.scale, step) / step_length(grid.scale, grid.step);
  const double whole = std::round(steps);
  const bool is_whole = whole >= 1.0 && whole <= static_cast<double>(kMostLevels) &&
                        std::abs(steps - whole) <= kRounding * whole;
  return is_whole ? static_cast<std::size_t>(whole) : 0;
}

}  // namespace asperity
