// The levels that a procedure can present.

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/numbers/level_scale.h"
#include "protocols/procedures/procedure_problems.h"

namespace asperity {

/// Levels in equal steps on a scale: lowest, one step above, … up to the last one that is not above `highest`.
///
/// Levels have the unit of the parameter that they vary. The grid is what a device must be able to present: a step
/// below its resolution presents the same surface under two names.
struct LevelGrid {
  LevelScale scale = LevelScale::linear;
  double lowest = 0.0;
  double highest = 0.0;
  double step = 0.0;  ///< in the unit of the scale

  bool operator==(const LevelGrid&) const = default;
};

/// The largest grid: every level is a stimulus that is checked and rehearsed.
inline constexpr std::size_t kMostLevels = 10000;

/// Reports the problems of a grid under the settings `scale`, `lowest`, `highest` and `step` of `name`.
void check_grid(const LevelGrid& grid, const std::string& name, ProcedureProblems& problems);

/// All functions below assume a grid without problems.
std::size_t size_of(const LevelGrid& grid);
/// From 0; the levels of equal index are equal bit for bit.
double level_of(const LevelGrid& grid, std::size_t index);
std::vector<double> levels_of(const LevelGrid& grid);
/// The index of the level that is nearest on the scale; the ends for a level beyond them.
std::size_t nearest_index(const LevelGrid& grid, double level);
/// Whether a level is on the grid, but for rounding (10⁻⁶ of a step).
bool is_on(const LevelGrid& grid, double level);
/// The number of grid steps in a step, or 0 where it is not a whole number above 0 (but for 10⁻⁶).
std::size_t grid_steps(const LevelGrid& grid, double step);

}  // namespace asperity
