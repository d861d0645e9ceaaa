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
/// A reading is plausible if |p − pᵢ| ≤ v·T and r·|θ| ≤ v·T', where pᵢ is the latest accepted position that is at least 1
/// ms old (otherwise the oldest that is known), T the time since then but at least 1 ms, v the greatest speed of the
/// device (DeviceCapability::maximum_speed_m_per_s), and θ the turn of the orientation in the time T'. One millisecond,
/// because one position step within a tick at 4 kHz is not a speed. r = 50 mm: the points of a tool that touch a surface
/// lie within centimetres of its reference point and move as far as it turns; at 5 m/s the limit is 100 rad/s, and a
/// hand turns a handle at 20 to 30 rad/s at most.
///
/// An implausible reading is held: the last accepted one takes its place, for at most 2 ms. If the readings are still
/// implausible then, the position of the hand is unknown, and the device is lost. T does not grow while a reading is held;
/// otherwise v·T would reach a position that has jumped for good before the 2 ms have passed. A hand of up to 1.6 m/s is
/// within v·T again after them.
///
/// After a pause of the line, the motion is judged over the whole pause, because a position that is merely repeated is not
/// accepted anew. It is repeated if the driver reports this, or if it is bit-identical although the hand moved when it was
/// read, for up to 50 ms; of a hand at rest a bit-identical position is a measurement, and what follows it is judged by
/// the time since then.
///
/// The orientation may have its own sensor with its own rate and pauses (a wireless grip). It is judged only when it
/// differs from the last one, over the time T' since it changed before. The identity, where the readings begin with it, is
/// the orientation of a sensor that has not reported yet: the first other one is accepted.
///
/// Real-time: does not allocate, lock or throw.
class ReadingCheck final {
 public:
  static constexpr double kShortest_s = 1e-3;
  static constexpr std::int64_t kLongestHold_ns = 2'000'000;
  static constexpr double kReach_m = 0.05;
  static constexpr std::int64_t kLongestPause_ns = 50'000'000;
  /// Below this speed, a hand moves by less than 5 m/s · 1 ms during the longest pause, which is plausible anyway; above
  /// it, by more than a position step of 0.1 mm in each tick at 1 kHz.
  static constexpr double kMoving_m_per_s = 0.1;

  enum class Verdict { plausible, held, lost };
  enum class Origin { fresh, repeated };

  explicit ReadingCheck(double maximum_speed_m_per_s) : maximum_m_per_s_(maximum_speed_m_per_s) {}

  /// Judges `reading`. One that is plausible is accepted. The first fresh one is plausible.
  Verdict judge(const ProbeState& reading, Origin origin) noexcept;
  /// Forgets all readings: the next one is the first.
  void restart() noexcept;

 private:
  /// The latest accepted values of one quantity: a millisecond of them at up to 16 kHz.
  template <typename Value>
  struct Past {
    struct Accepted {
      std::int64_t time_ns = 0;
      Value value{};
    };
    std::array<Accepted, 16> accepted{};
    std::size_t newest_index = 0;
    std::size_t count = 0;

    void add(std::int64_t time_ns, const Value& value) noexcept {
      newest_index = (newest_index + 1) % accepted.size();
      accepted[newest_index] = {time_ns, value};
      if (count < accepted.size()) ++count;
    }
    const Accepted& newest() const noexcept { return accepted[newest_index]; }
    /// The latest that is at least kShortest_s older than `time_ns`, otherwise the oldest. Not of an empty one.
    const Accepted& before(std::int64_t time_ns) const noexcept;
  };

  double farthest_m(std::int64_t from_ns, std::int64_t to_ns) const noexcept;
  bool is_plausible(const ProbeState& reading, std::int64_t at_ns) const noexcept;
  bool is_paused(const ProbeState& reading) const noexcept;
  void accept(const ProbeState& reading) noexcept;

  double maximum_m_per_s_;
  Past<glm::dvec3> positions_m_{};
  Past<glm::dquat> orientations_{};  // empty while unknown
  bool is_moving_ = false;           // when the position changed last
  bool is_holding_ = false;
  std::int64_t held_since_ns_ = 0;
};

}  // namespace asperity
