// Velocity out of positions, with its lag and noise declared.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <glm/vec3.hpp>

#include "device/device_capability.h"
#include "device/reading_check.h"

namespace asperity {

/// How a driver estimates velocity; `samples` readings enter.
struct VelocityWindow {
  int samples = 8;  ///< 2 to VelocityEstimator::kMostSamples

  /// At readings T apart: the estimate is the velocity of this long ago, (n − 1)T/2.
  double lag_s(double period_s) const noexcept;
  /// Standard deviation of the estimate where positions carry independent errors of standard
  /// deviation σ: σ/T · √(12/(n(n² − 1))). A sensor of resolution r counts as σ = r/√12.
  double noise_m_per_s(double position_noise_m, double period_s) const noexcept;
};

/// The fastest turn of a hand: at it, the reach of a tool moves as fast as the fastest hand.
inline constexpr double kFastestTurn_rad_per_s = kFastestHand_m_per_s / ReadingCheck::kReach_m;

/// The slope of the straight line that fits the last n positions best, in the sense of least squares,
/// at the times at which they were read:
///
///   v = Σ (tᵢ − t̄) xᵢ / Σ (tᵢ − t̄)²
///
/// Exact for any motion at constant velocity, however irregular the readings; under constant
/// acceleration and at even readings it is the velocity (n − 1)T/2 ago, exactly. Until n readings are
/// there, those that are; 0 from a single one.
///
/// A reading that implies a speed that no hand has (reading_check.h) does not enter: the estimate keeps its value. If such
/// readings last longer than the check holds them, the position has jumped, and the estimate begins anew.
///
/// Errors: the constructor throws std::invalid_argument for a window that is not 2 to kMostSamples.
///
/// Real-time: `add` and `reset` do not allocate, lock or throw.
class VelocityEstimator final {
 public:
  static constexpr int kMostSamples = 64;

  /// `fastest_per_s`: of positions in metres; kFastestTurn_rad_per_s for angles.
  explicit VelocityEstimator(const VelocityWindow& window,
                             double fastest_per_s = kFastestHand_m_per_s);

  /// The velocity after one more reading. One that is no newer than the last is not counted.
  glm::dvec3 add(std::int64_t time_ns, const glm::dvec3& position_m) noexcept;
  /// Forgets all: the next reading has nothing to do with those before.
  void reset() noexcept;

 private:
  struct Reading {
    std::int64_t time_ns = 0;
    glm::dvec3 position_m{0.0};
  };
  std::array<Reading, kMostSamples> readings_{};
  std::size_t window_ = 2;
  std::size_t count_ = 0;
  std::size_t newest_ = 0;
  glm::dvec3 velocity_m_per_s_{0.0};
  ReadingCheck check_;
};

}  // namespace asperity
