// How fast something moves, from its last few positions.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <glm/vec3.hpp>

namespace asperity {

/// The slope of the straight line that lies closest (least squares) to the last kReadings positions.
///
/// Times may be uneven. With readings every T seconds it lags the motion by (n − 1)/2·T, 2 ms at
/// 1 kHz, and noise of the standard deviation σ in each position becomes σ/(T·√(n(n² − 1)/12)) in
/// the velocity, σ·316/s at 1 kHz. A constant velocity is found exactly. With one reading the velocity is 0, with
/// fewer than kReadings the line lies through those that there are.
///
/// Real-time: `next` does not allocate, lock or throw.
class VelocityWindow final {
 public:
  static constexpr std::size_t kReadings = 5;

  /// Readings come in order; one with the time of the last is left out.
  glm::dvec3 next(std::int64_t time_ns, const glm::dvec3& position_m) noexcept;
  /// Forgets what was read: the next reading begins a motion of its own.
  void reset() noexcept { count_ = 0; }

 private:
  struct Reading {
    std::int64_t time_ns = 0;
    glm::dvec3 position_m{0.0};
  };
  glm::dvec3 slope() const noexcept;

  std::array<Reading, kReadings> readings_{};  // the oldest is overwritten
  std::size_t count_ = 0;
  std::size_t newest_ = 0;
};

}  // namespace asperity
