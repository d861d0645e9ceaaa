// Declares how the force continues after a gap between two ticks.

#pragma once

#include "device/wrench.h"

namespace asperity {

/// After a gap, continues from the wrench that was sent before it and approaches the wrench of the surface.
///
/// During a gap the hand moves on while the motors hold the last force, so that the surface's force may be another one
/// when the next tick comes. Over the length of the gap, but at least 2 ms and at most 50 ms,
///
///   f = p + (t/T)·(a − p)
///
/// with a the wrench that is wanted now, t the time since the gap including this tick, and p the point nearest to a among
/// the falls of the wrench sent before the gap (nearest_on_fall). A fall is therefore immediate: where the hand has left
/// the surface in the gap, a = 0 and f = 0. p only falls while the gap is bridged. Force and torque are treated
/// separately.
///
/// A gap of the length g that ends within the bridge of one at least as long, the time t after it began, continues the bridge
/// from the wrench that was sent, with the length
///
///   T⁺ = (1 − t/T)·(T − t) + (t/T)·g
///
/// Of what was sent, the share 1 − t/T is held from before, and falls to 0 within T − t; the share t/T is the surface's before
/// the new gap, to be bridged over g. With T⁺ their sum has the same integral over time. In a row of gaps of n ticks, one before
/// each tick, T⁺ becomes (n + 1)/2 ticks, and the growth is delayed by half as much as if each bridge began anew: the delay
/// feeds energy to the hand, because a fall has none. A gap in the last tick of a bridge is bridged over its own length; none
/// is bridged over less than half of it.
///
/// Real-time: does not allocate, lock or throw.
class GapBridge final {
 public:
  static constexpr double kShortest_s = 0.002;
  static constexpr double kLongest_s = 0.050;

  /// A gap of `gap_s` has ended, before which `sent` was sent.
  void begin(const Wrench& sent, double gap_s) noexcept;
  /// What is sent instead of `wanted`, `elapsed_s` after the previous tick; `wanted` itself after the bridge. A negative
  /// `elapsed_s` (a clock that was set back) counts as 0.
  Wrench approach(const Wrench& wanted, double elapsed_s) noexcept;

 private:
  Wrench from_{};
  double gap_s_ = 0.0;  // the longest that is still bridged, clamped
  double length_s_ = 0.0;
  double passed_s_ = 0.0;
};

}  // namespace asperity
