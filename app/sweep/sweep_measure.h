// Declares a row of a sweep and its measures.

#pragma once

#include <optional>
#include <span>
#include <string>

#include "renderers/offline/roughness_stroke.h"

namespace asperity {

/// One cell: a level of the varied quantity at one spacing.
struct SweepRow {
  double value = 0.0;
  double spacing_m = 0.0;
  std::optional<HeldToolRoughness> roughness{};
  std::optional<TurningRoughness> turning{};  ///< of a tool that turns
  std::string status{};                       ///< as in drag.h, or `no_effect_by_construction`
};

/// A measure of a row.
enum class SweepMeasure {
  max_accel,
  rms_accel,
  fa1,
  fa2,
  pacinian,
  rms_torque,
  fa1_torque,
  fa2_torque,
  rms_force,
  fa1_force,
  fa2_force
};

/// The entry of a measure in the registry.
struct MeasureEntry {
  SweepMeasure measure = SweepMeasure::max_accel;
  const char* name = "";
  const char* column = "";     ///< of the table
  bool is_of_turning = false;  ///< only of a tool that turns
  bool is_decibels = false;    ///< of a power; a decade is 10 dB
  std::optional<double> (*value)(const SweepRow&) = nullptr;
  void (*set)(SweepRow&, double) = nullptr;  ///< for a table that is read
};

/// All measures, in the order of their columns.
std::span<const MeasureEntry> sweep_measures();
const MeasureEntry& entry_of(SweepMeasure measure);

/// As in the name of its column, without the unit.
const char* text_of(SweepMeasure measure) noexcept;
/// The decimal logarithm of the measure, for the Pacinian power that of P_w, a tenth of the
/// decibels; nothing where the tool did not move, or not in that band.
std::optional<double> log10_of(const SweepRow& row, SweepMeasure measure);

}  // namespace asperity
