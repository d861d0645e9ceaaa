// Declares the check that a reading of the hand is plausible.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "device/probe_state.h"

namespace asperity {

/// Judges each reading by the speed that it implies.
///
/// A reading is plausible if |p − pᵢ| ≤ v·T and r·|θ| ≤ v·T, where pᵢ is the latest accepted position that is at least 1
/// ms old (otherwise the oldest that is known), T the time since then but at least 1 ms, v the greatest speed of the
/// device (DeviceCapability::maximum_speed_m_per_s), and θ the turn of the attitude in that time. One millisecond,
/// because one position step within a tick at 4 kHz is not a speed. r = 50 mm: the points of a tool that touch a surface
/// lie within centimetres of its reference point and move as far as it turns; at 5 m/s the limit is 100 rad/s, and a
/// hand turns a handle at 20 to 30 rad/s at most.
///
/// An implausible reading is held: the last accepted one takes its place, for at most 2 ms. If the readings are still
/// implausible then, the position of the hand is unknown, and the device is lost.
///
/// A reading that the driver merely repeats does not count as new: after a pause of the line, the motion is judged over
/// the whole pause.
///
/// Real-time: does not allocate, lock or throw.
class ReadingCheck final {
 public:
  static constexpr double kShortest_s = 1e-3;
  static constexpr std::int64_t kLongestHold_ns = 2'000'000;
  static constexpr double kReach_m = 0.05;

  enum class Verdict { plausible, held, lost };
  enum class Origin { fresh, repeated };

  explicit ReadingCheck(double maximum_speed_m_per_s) : maximum_m_per_s_(maximum_speed_m_per_s) {}

  /// Judges `reading`. One that is plausible is accepted.
  Verdict judge(const ProbeState& reading, Origin origin) noexcept;
  /// Accepts `reading` whatever came before: no surface is felt, so that no force depends on it.
  void restart(const ProbeState& reading) noexcept;

 private:
  struct Accepted {
    std::int64_t time_ns = 0;
    glm::dvec3 position_m{0.0};
    glm::dquat orientation{1.0, 0.0, 0.0, 0.0};
  };

  bool is_plausible(const ProbeState& reading) const noexcept;
  void accept(const ProbeState& reading) noexcept;

  double maximum_m_per_s_;
  // A millisecond of readings at up to 16 kHz; the newest at `newest_`.
  std::array<Accepted, 16> accepted_{};
  std::size_t newest_ = 0;
  std::size_t count_ = 0;
  bool is_holding_ = false;
  std::int64_t held_since_ns_ = 0;
};

}  // namespace asperity
