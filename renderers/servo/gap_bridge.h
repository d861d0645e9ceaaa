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
/// A gap that ends within the bridge of one at least as long does not begin another: the bridge continues from the wrench
/// that was sent, and ends when it would have ended. If each of many gaps in a row began anew, the force would grow with a
/// delay and fall without one in each, which feeds energy to the hand.
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
  double gap_s_ = 0.0;  // the longest of those that are bridged, clamped
  double length_s_ = 0.0;
  double passed_s_ = 0.0;
};

}  // namespace asperity
