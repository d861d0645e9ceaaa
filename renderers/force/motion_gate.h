// Declares the fading of a texture of the path where the hand stops.

#pragma once

#include <algorithm>

namespace asperity {

/// Fades what a path has led to in and out, so that a hand at rest feels no texture even where the device's velocity
/// varies about zero.
///
///   g → 1 by dt/20 ms     while the path (PathClock) has grown within the last 40 ms
///   g → 0 by dt/20 ms     otherwise; 0 at a reset
///
/// With the shortest dead zone of PathClock, 20 µm, g is 1 for a hand that is faster than 0.5 mm/s.
///
/// Real-time: no allocation, no exceptions.
class MotionGate final {
 public:
  void reset() noexcept { *this = {}; }

  /// g after a tick in which the path has reached `length_m`.
  double advance(double length_m, double dt_s) noexcept {
    since_s_ = length_m > length_m_ ? 0.0 : since_s_ + dt_s;
    length_m_ = length_m;
    const bool moves = length_m > 0.0 && since_s_ < kPause_s;
    gain_ = std::clamp(gain_ + (moves ? dt_s : -dt_s) / kFade_s, 0.0, 1.0);
    return gain_;
  }

 private:
  static constexpr double kPause_s =
      0.040;  // 20 µm at 0.5 mm/s, where texture is no longer felt as motion
  static constexpr double kFade_s = 0.020;  // longer than a period of the vibrations that it fades
  double length_m_ = 0.0;
  double since_s_ = 0.0;
  double gain_ = 0.0;
};

}  // namespace asperity
