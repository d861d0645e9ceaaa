// The parts of a device test, in the order in which they run. Each is a source file.

#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "analysis/signals/device_response.h"
#include "app/device_bench/test/device_test_run.h"

namespace asperity {

/// Rate, lateness, force and position noise of a loop without a surface.
void measure_timing(DeviceTestRun& run);

/// Whether every force is limited, and becomes 0 when it has to.
void check_safety(DeviceTestRun& run);

/// The resistance to slow motion along each axis; stores no items.
struct Sweeps {
  std::array<std::optional<Resistance>, kTestedAxes> resistances{};
  std::array<Phrase, kTestedAxes> blockers{};  ///< why a resistance is missing
  ByAxis position_step_m{};

  const std::optional<Resistance>& resistance(int axis) const {
    return resistances[static_cast<std::size_t>(axis)];
  }
  const Phrase& blocker(int axis) const { return blockers[static_cast<std::size_t>(axis)]; }
  double friction_N(int axis) const;         ///< 0 if unknown
  double stiffness_N_per_m(int axis) const;  ///< of what holds the handle; 0 if unknown
};
Sweeps measure_sweeps(DeviceTestRun& run);

/// Latency and moving mass from force steps; with them also stores friction, damping and the position step of the
/// sweeps. Returns the moving mass, in kg.
ByAxis measure_pushes(DeviceTestRun& run, const Sweeps& sweeps);

/// The responses to tones, and the resonance.
void measure_tones(DeviceTestRun& run, const Sweeps& sweeps);

/// The stiffest spring on which the handle comes to rest.
void measure_springs(DeviceTestRun& run, const Sweeps& sweeps);

/// The weakest push that moves the handle.
void measure_small_pushes(DeviceTestRun& run, const Sweeps& sweeps, const ByAxis& mass_kg);

/// The part of the workspace that a person reaches.
void measure_workspace(DeviceTestRun& run);

}  // namespace asperity
