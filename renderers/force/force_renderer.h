// The place where a stimulus meets a hand.

#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "device/probe_state.h"
#include "renderers/force/rendered_tick.h"

namespace asperity {

/// In how many ticks something was so; what it is stands with the model that counts it.
struct NamedCount {
  std::string_view name{};  ///< `[a-z][a-z0-9_]*`, of a literal: it outlives the renderer
  std::uint64_t ticks = 0;
};

/// Turns the motion of the probe into the wrench it should feel, once per servo tick.
///
/// A renderer is built for one stimulus, off the servo thread, where it may allocate, tabulate and
/// refuse. From then on it is a deterministic machine: what it returns depends on its constructor's
/// arguments and on the samples since `reset`, and on nothing else: no clock, no thread of its own,
/// no global. A recorded run therefore replays, which is how the tests hold a renderer to what a
/// participant once felt.
///
/// Units and frame: SI, in the device's frame; the stimulus's SurfacePatch says where the surface
/// lies in it (+z outward). The wrench is the surface's on the hand; its torque is about the
/// probe's tip.
///
/// Stability: on a device with viscous damping b, refreshed every T seconds, a linear surface of stiffness K and damping B
/// is passive while b > K·T/2 + |B| [Colgate 1997]. K is the steepest the surface shows, texture included: a fine grating
/// is stiffer than its plate. Friction is a damper near rest, and vibrates where it is too steep for the device's mass and
/// for the age of its velocity. Both are derived in offline/sampled_loop.h. A renderer never softens or clips
/// its own force to save a device: ramping is ServoLoop's and limiting is HapticDevice's, so that
/// the record keeps what was meant.
///
/// Real-time: `reset` and `tick` run on the servo thread. They must not allocate, lock, block, log
/// or throw; the allocation guard in tests/support and bench/servo_tick hold them to it.
class ForceRenderer {
 public:
  virtual ~ForceRenderer() = default;
  ForceRenderer(const ForceRenderer&) = delete;
  ForceRenderer& operator=(const ForceRenderer&) = delete;

  /// Forgets the past. `first` is where the hand is when the surface appears.
  virtual void reset(const ProbeState& first) noexcept = 0;

  /// The wrench for this sample and how deep the probe is in the surface. Samples come in order.
  /// `dt_s` is the time since the last one, already clamped; always positive.
  virtual RenderedTick tick(const ProbeState& probe, double dt_s) noexcept = 0;

  /// In how many ticks since its construction what the model takes for granted did not hold, by what
  /// it was: always the same names in the same order, with zeros. Empty for a model without such
  /// limits. `reset` does not clear them, so that a fault in the middle of an attempt loses none.
  ///
  /// Threads: plain counters of the servo thread. Read them where no tick can come: after
  /// ServoLoop::collect gave the renderer back, or where the loop is stepped.
  virtual std::span<const NamedCount> limits() const noexcept { return {}; }

 protected:
  ForceRenderer() = default;
};

}  // namespace asperity
