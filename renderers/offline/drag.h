// A held tool dragged over a surface, and how rough that is.

#pragma once

#include <optional>
#include <stop_token>

#include "analysis/roughness.h"
#include "renderers/force/force_renderer.h"
#include "renderers/offline/held_tool.h"

namespace asperity {

enum class DragMode {
  constant_height,  ///< at the height at which the mean normal force along the stroke is the given one
  constant_force,  ///< free to rise and fall, pressed by the given force
};

/// One stroke.
struct Drag {
  HandModel hand{};
  DragMode mode = DragMode::constant_height;
  double speed_m_per_s = 0.1;
  double force_N = 0.5;
  /// Of the texture: the record is a whole number of them, in time at constant speed.
  double spacing_m = 0.002;
  double repeats_after_m = 0.002;  ///< the whole texture; heights are judged over one of these
  double start_x_m = 0.0;
  double stiffness_N_per_m = 1000.0;  ///< of the surface
  double reach_m = 0.0;  ///< how far the surface goes on from `start_x_m`; 0: without end
};

enum class DragStatus {
  ok,
  stick_slip,  ///< the tool was caught: slower than a twentieth of the hand's speed, or backwards
  not_converged,  ///< the measures still changed at the smallest time step
  saturated,      ///< somewhere the surface pushed no harder where it was pressed deeper
};
const char* text_of(DragStatus status) noexcept;
const char* text_of(DragMode mode) noexcept;

struct DragResult {
  DragStatus status = DragStatus::ok;
  /// Nothing where no height has the mean normal force.
  std::optional<HeldToolRoughness> roughness{};
  double height_m = 0.0;     ///< of the tip over the plane; at constant force: at the beginning
  double time_step_s = 0.0;  ///< the one that the measures are of
  double slowest_m_per_s = 0.0;
};

/// How long the beginning is that a stroke drops: eight times as long as the slowest mode of the hand
/// takes to fall to 1/e, against a surface of that stiffness where the hand presses with a force.
double beginning_s(const HandModel& hand, std::optional<double> surface_N_per_m);

/// The simulation knows no thread and no clock; it steps as a servo would, in ever smaller steps.
///
/// At first the tool moves with the hand, at the height at which the mean normal force is the given
/// one: over the texture from `start_x_m` on, 256 samples a spacing, nothing yielding. What is left of
/// the beginning is dropped (`beginning_s`). The record that follows is a number of spacings that is a
/// power of two: at least 16, at least half a second at the hand's speed. (With a `reach_m` fewer, down
/// to four, so that the stroke fits.)
///
/// Time steps: a power of two in a spacing, 50 µs at most, and halved until the largest and the RMS
/// acceleration change by less than 1 % and the powers by less than 2 %, or less than 10⁻⁴ of the
/// mean square; the measures are those of the smaller step. Five halvings are the most. Accelerations
/// that stay below 10⁻⁶ m/s² are rounding and count as none.
///
/// Saturated: where the tool went, 10 µm deeper raises the normal force by less than a tenth of what the
/// surface's stiffness says, or no height has the mean normal force. Of several, the status is
/// saturated before not_converged before stick_slip.
///
/// Nothing when it was asked to stop. Errors: std::invalid_argument, naming the field, for what is not
/// positive, and a `reach_m` that is too short for four spacings.
std::optional<DragResult> drag(ForceRenderer& renderer, const Drag& stroke,
                               const std::stop_token& stop = {});

}  // namespace asperity
