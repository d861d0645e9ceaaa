// Declares the interface of the force renderers.

#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "device/probe_state.h"
#include "renderers/force/rendered_tick.h"

namespace asperity {

class Friction;
class TipOnCharts;

/// The number of ticks in which a condition held. The model that counts the condition documents it.
struct NamedCount {
  std::string_view name{};  ///< `[a-z][a-z0-9_]*`; points to a literal and outlives the renderer
  std::uint64_t ticks = 0;
};

/// Computes the wrench on the probe from the probe's motion, once per servo tick.
///
/// A renderer is built for one stimulus outside the servo thread, where its constructor may allocate, tabulate and
/// throw. Afterwards it is deterministic: its results depend only on the constructor's arguments and on the samples
/// since `reset`, not on a clock, a separate thread or global state. A replayed recording therefore gives the recorded
/// forces, which the tests check.
///
/// Units and frame: SI, in the device's frame; the stimulus's SurfacePatch gives the position of the surface in it (+z
/// outward). The wrench is the one that the surface exerts on the hand; its torque is about the probe's tip.
///
/// Stability: on a device with viscous damping b, refreshed every T seconds, a linear surface of stiffness K and
/// damping B is passive while b > K·T/2 + |B| [Colgate 1997]. K is the greatest stiffness of the surface including its
/// texture: a fine grating is stiffer than its plate. Friction acts as a damper near rest and causes vibration where it
/// is too steep for the device's mass and for the age of its velocity. Both limits are derived in
/// offline/sampled_loop.h. A renderer never reduces or clips its force to protect a device: ServoLoop applies the ramp
/// and HapticDevice the limits, so that the record contains the intended force.
///
/// Real-time: `reset` and `tick` run on the servo thread. They must not allocate, lock, block, log or throw; the
/// allocation guard in tests/support checks this.
class ForceRenderer {
 public:
  virtual ~ForceRenderer() = default;
  ForceRenderer(const ForceRenderer&) = delete;
  ForceRenderer& operator=(const ForceRenderer&) = delete;

  /// Clears all state. `first` is the first sample of the presentation.
  virtual void reset(const ProbeState& first) noexcept = 0;

  /// The wrench and the penetration for this sample. Samples arrive in temporal order. `dt_s` is the time since the
  /// previous sample, already clamped and always positive.
  virtual RenderedTick tick(const ProbeState& probe, double dt_s) noexcept = 0;

  /// The friction of a contact with a surface, for a renderer that hands a contact over from one surface to the next
  /// (AdjacentPatches); null for a renderer without one. Servo thread only.
  virtual Friction* friction() noexcept { return nullptr; }

  /// The tip of a contact that extends over an area, for a renderer that brings it onto a body (PointOnBody); null for that of a
  /// point. Servo thread only.
  virtual TipOnCharts* tip() noexcept { return nullptr; }

  /// The number of ticks since construction in which each assumption of the model was violated: the same names in the
  /// same order at every call, zeros included. Empty for a model without such limits. `reset` does not clear the
  /// counts, so that a fault during an attempt loses none.
  ///
  /// Threads: plain counters of the servo thread. Read them only when no tick can run: after ServoLoop::collect has
  /// returned the renderer, or in a loop that is stepped.
  virtual std::span<const NamedCount> limits() const noexcept { return {}; }

  /// Why the model stopped computing forces, of a model that can fail in a tick (a plug-in): its last error since
  /// construction. Empty for none. Threads: as `limits`.
  virtual std::string_view error() const noexcept { return {}; }

 protected:
  ForceRenderer() = default;
};

}  // namespace asperity
