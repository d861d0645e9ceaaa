// Declares a dimension of a block: the parameter that its trials vary, and the levels.

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "protocols/procedures/level_grid.h"

namespace asperity {

/// What the levels of a dimension state about a value x of the parameter, given the value s of a standard:
///
///   value       x            in the unit of the parameter
///   difference  x − s        in the unit of the parameter
///   percent     100·(x − s)/s
///   ratio       x/s
///   decibels    20·log10(x/s)
///
/// All but the first two require s > 0.
enum class LevelMeasure { value, difference, percent, ratio, decibels };

/// The value x of a level, rounded to 12 significant digits unless it is stated itself; and the level of a value.
double value_at(LevelMeasure measure, double level, double standard);
double level_at_value(LevelMeasure measure, double value, double standard);
/// Whether a standard is required, and whether it must be above 0.
bool is_relative(LevelMeasure measure) noexcept;
bool needs_positive_standard(LevelMeasure measure) noexcept;
/// The key of a protocol that states levels of this measure: "levels", "levels_percent", …
std::string_view key_of(LevelMeasure measure) noexcept;

/// The parameter of every stimulus whose model has an amplitude (StimulusDescription::relative_amplitude). It varies models
/// whose amplitudes have different names and units by one dimension. A standard has the value 1.
inline constexpr std::string_view kRelativeAmplitude = "relative_amplitude";

/// A factor of a block whose levels are values of one parameter of one of the surfaces: the key "vary" of a block.
///
/// In a block without a procedure every combination of the other factors is presented with every level. A procedure
/// chooses the levels from the answers (BlockProcedure).
struct Dimension {
  std::string factor{};         ///< the name of the factor; that of the parameter unless stated
  std::string parameter{};      ///< of the force model
  std::string role{};           ///< of the surface whose parameter is varied
  std::string standard_role{};  ///< of the surface to which levels refer; empty: none
  LevelMeasure measure = LevelMeasure::value;
  std::vector<double> list{};       ///< as stated, or
  std::optional<LevelGrid> grid{};  ///< in the unit of the measure
  /// The value of the parameter in the stimulus of the standard; absent without a standard, or if it is not stated.
  std::optional<double> standard{};
  std::string unit{};     ///< of the parameter, as its force model declares it
  std::string meaning{};  ///< the same

  /// The levels as stated, ascending; none of a grid with problems.
  std::vector<double> levels() const;
  /// The same as values of the parameter.
  std::vector<double> values() const;
  bool is_relative_amplitude() const noexcept { return parameter == kRelativeAmplitude; }
  /// The level of the standard: its value, a difference of 0, or a ratio of 1.
  double level_of_standard() const;
  double value_of(double level) const { return value_at(measure, level, standard.value_or(0.0)); }
  double level_of(double value) const {
    return level_at_value(measure, value, standard.value_or(0.0));
  }
};

/// Whether levels are stated, and the grid, if there is one, can be computed.
bool has_levels(const Dimension& dimension);

}  // namespace asperity
