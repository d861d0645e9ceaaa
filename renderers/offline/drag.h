// Declares the simulation of a held tool that is dragged over a surface, and its roughness.

#pragma once

#include <memory>
#include <optional>
#include <stop_token>

#include "analysis/signals/roughness.h"
#include "renderers/force/force_renderer.h"
#include "renderers/offline/held_tool.h"
#include "renderers/offline/stroke_guide.h"

namespace asperity {

enum class DragMode {
  constant_height,  ///< the height at which the mean normal force along the stroke is the given one
  constant_force,   ///< free normal motion under the given force
};

/// The parameters of one stroke. Lengths along the stroke are those of its guide.
struct Drag {
  HandModel hand{};
  DragMode mode = DragMode::constant_height;
  double speed_m_per_s = 0.1;
  double force_N = 0.5;
  /// Of the texture: the record is a whole number of spacings, in time at constant speed.
  double spacing_m = 0.002;
  double repeats_after_m = 0.002;  ///< period of the texture; the height is found over one
  double start_x_m = 0.0;
  double stiffness_N_per_m = 1000.0;  ///< of the surface
  double reach_m = 0.0;               ///< length of the surface from `start_x_m`; 0: unlimited
  std::shared_ptr<const StrokeGuide> guide{};  ///< null: the x axis
  /// The amplitude of a stroke to and fro about the beginning of the guide, in which `speed_m_per_s` is the greatest speed; 0:
  /// the hand moves on at this speed.
  double swing_m = 0.0;
};

/// The torque and the force of the surface during a stroke on an arc, without their means. Mean squares in a band are powers, as
/// in RecordRoughness.
struct TurningRoughness {
  double rms_torque_N_m = 0.0;  ///< about the axis of the arc
  double fa1_torque_N2_m2 = 0.0;
  double fa2_torque_N2_m2 = 0.0;
  double rms_force_N = 0.0;  ///< the three components added as powers
  double fa1_force_N2 = 0.0;
  double fa2_force_N2 = 0.0;
};

enum class DragStatus {
  ok,
  stick_slip,     ///< the tool stuck: slower than a twentieth of the hand's speed, or backwards
  not_converged,  ///< the measures still changed at the smallest time step
  lost_contact,   ///< without contact for more than kMostWithoutContact of the time
  saturated,      ///< somewhere the force did not increase with depth
};
const char* text_of(DragStatus status) noexcept;
const char* text_of(DragMode mode) noexcept;

/// The largest proportion of the record in which a tool that follows a texture is in the air. A tool that bounces is chaotic, and
/// its accelerations are those of its impacts.
inline constexpr double kMostWithoutContact = 0.05;

struct DragResult {
  DragStatus status = DragStatus::ok;
  /// nullopt if no height has the mean normal force.
  std::optional<HeldToolRoughness> roughness{};
  std::optional<TurningRoughness> turning{};  ///< of a stroke whose guide turns the tool
  double height_m = 0.0;     ///< of the tip over the guide; at constant force: initially
  double time_step_s = 0.0;  ///< of the simulation that gave the measures
  double slowest_m_per_s = 0.0;
  double share_without_contact = 0.0;  ///< of the time of the record
};

/// The duration of the dropped beginning of a stroke: eight time constants (decay to 1/e) of the slowest mode of the
/// hand, against a surface of this stiffness if the hand presses with a force.
double beginning_s(const HandModel& hand, std::optional<double> surface_N_per_m);

/// The guide and the motion to and fro. With s the place along the guide and w the height above it,
///
///   to and fro   s = a·sin(v·t/a) + d,   m·d̈ = −k_h·d − b_h·ḋ + F_s
///   otherwise    m·s̈ = k_h·(v·t − s) + b_h·(v − ṡ) + F_s
///
/// F_s is the force along the guide (StrokeGuide) and a the `swing_m`: without a surface the tool follows the sinusoid, and the
/// deviation d is the effect of the surface. The spring and the damper are linear, so that the acceleration of the tool is the
/// sum of both, and the measures are those of d̈ and ẅ. On an arc of radius r the torque about its axis is r·F_s, and
/// the inertia, spring and damper of the hand about it are m·r², k_h·r² and b_h·r².
///
/// Simulates the stroke without thread or clock, in steps like a servo's, with decreasing time steps.
///
/// Initially the tool moves with the hand, at the height at which the mean normal force is the given one: over the
/// texture from `start_x_m`, with 256 samples per spacing, without yielding. The beginning (`beginning_s`) is dropped.
/// The record that follows has a number of spacings that is a power of two: at least 16, and at least half a second at
/// the hand's speed. (With a `reach_m` fewer, down to four, so that the stroke fits.)
///
/// Time steps: a power of two per spacing, at most 50 µs, and halved until the largest and the RMS acceleration change
/// by less than 1 % and the powers by less than 2 %, or less than 10⁻⁴ of the mean square; the measures are those of
/// the smaller step. There are at most five halvings. Accelerations below 10⁻⁶ m/s² are rounding errors and count as
/// zero.
///
/// To and fro, the record is a number of periods 2π·a/v that is a power of two: at least four, and at least half a second; the
/// height is found over the whole arc. `stick_slip`: while the hand is faster than half its greatest speed, the tool is
/// slower than a twentieth of that, or moves backwards.
///
/// Saturated: where the tool was, 10 µm more depth increase the normal force by less than a tenth of the value for the
/// surface's stiffness, or no height has the mean normal force. If several statuses apply, saturated takes precedence
/// over lost_contact, that over not_converged, and that over stick_slip.
///
/// nullopt if stopped by `stop`. Errors: std::invalid_argument, naming the field, for a value that is not positive, and
/// for a `reach_m` that is too short for four spacings.
std::optional<DragResult> drag(ForceRenderer& renderer, const Drag& stroke,
                               const std::stop_token& stop = {});

}  // namespace asperity
