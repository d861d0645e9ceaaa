// Holds the table of measures: name, column, and the member of a row.

#include "app/sweep/sweep_measure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace asperity {

namespace {

template <double HeldToolRoughness::*Member>
constexpr MeasureEntry of_acceleration(SweepMeasure measure, const char* name, const char* column) {
  return {.measure = measure,
          .name = name,
          .column = column,
          .value = [](const SweepRow& row) -> std::optional<double> {
            return row.roughness ? std::optional((*row.roughness).*Member) : std::nullopt;
          },
          .set =
              [](SweepRow& row, double value) {
                if (!row.roughness) row.roughness.emplace();
                (*row.roughness).*Member = value;
              }};
}

template <double TurningRoughness::*Member>
constexpr MeasureEntry of_turning(SweepMeasure measure, const char* name, const char* column) {
  return {.measure = measure,
          .name = name,
          .column = column,
          .is_of_turning = true,
          .value = [](const SweepRow& row) -> std::optional<double> {
            return row.turning ? std::optional((*row.turning).*Member) : std::nullopt;
          },
          .set =
              [](SweepRow& row, double value) {
                if (!row.turning) row.turning.emplace();
                (*row.turning).*Member = value;
              }};
}

constexpr std::array kMeasures{
    of_acceleration<&HeldToolRoughness::max_accel_m_per_s2>(SweepMeasure::max_accel, "max_accel",
                                                            "roughness_max_accel_m_per_s2"),
    of_acceleration<&HeldToolRoughness::rms_accel_m_per_s2>(SweepMeasure::rms_accel, "rms_accel",
                                                            "roughness_rms_accel_m_per_s2"),
    of_acceleration<&HeldToolRoughness::fa1_m2_per_s4>(SweepMeasure::fa1, "fa1",
                                                       "roughness_fa1_m2_per_s4"),
    of_acceleration<&HeldToolRoughness::fa2_m2_per_s4>(SweepMeasure::fa2, "fa2",
                                                       "roughness_fa2_m2_per_s4"),
    MeasureEntry{.measure = SweepMeasure::pacinian,
                 .name = "pacinian",
                 .column = "roughness_pacinian_dB",
                 .is_decibels = true,
                 .value =
                     [](const SweepRow& row) {
                       return row.roughness ? row.roughness->pacinian_dB : std::nullopt;
                     },
                 .set =
                     [](SweepRow& row, double value) {
                       if (!row.roughness) row.roughness.emplace();
                       row.roughness->pacinian_dB = value;
                     }},
    of_turning<&TurningRoughness::rms_torque_N_m>(SweepMeasure::rms_torque, "rms_torque",
                                                  "roughness_rms_torque_N_m"),
    of_turning<&TurningRoughness::fa1_torque_N2_m2>(SweepMeasure::fa1_torque, "fa1_torque",
                                                    "roughness_fa1_torque_N2_m2"),
    of_turning<&TurningRoughness::fa2_torque_N2_m2>(SweepMeasure::fa2_torque, "fa2_torque",
                                                    "roughness_fa2_torque_N2_m2"),
    of_turning<&TurningRoughness::rms_force_N>(SweepMeasure::rms_force, "rms_force",
                                               "roughness_rms_force_N"),
    of_turning<&TurningRoughness::fa1_force_N2>(SweepMeasure::fa1_force, "fa1_force",
                                                "roughness_fa1_force_N2"),
    of_turning<&TurningRoughness::fa2_force_N2>(SweepMeasure::fa2_force, "fa2_force",
                                                "roughness_fa2_force_N2")};

static_assert(
    [] {
      for (std::size_t i = 0; i < kMeasures.size(); ++i) {
        if (static_cast<std::size_t>(kMeasures[i].measure) != i) return false;
      }
      return true;
    }(),
    "the registry has the order of the enumeration");

}  // namespace

std::span<const MeasureEntry> sweep_measures() { return kMeasures; }

const MeasureEntry& entry_of(SweepMeasure measure) {
  return kMeasures[static_cast<std::size_t>(measure)];
}

const char* text_of(SweepMeasure measure) noexcept {
  return kMeasures[static_cast<std::size_t>(measure)].name;
}

std::optional<double> log10_of(const SweepRow& row, SweepMeasure measure) {
  const MeasureEntry& entry = entry_of(measure);
  const std::optional<double> value = entry.value(row);
  if (!value) return {};
  if (entry.is_decibels) return 0.1 * *value;
  return *value > 0.0 ? std::optional(std::log10(*value)) : std::nullopt;
}

}  // namespace asperity
