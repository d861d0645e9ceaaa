// Implements the low-pass of a recorded motion.

#include "renderers/offline/slow_hand.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>

#include <glm/gtc/quaternion.hpp>

#include "analysis/signals/filters.h"
#include "renderers/servo/contact.h"

namespace asperity {
namespace {

constexpr LowPass kSlow{.order = 2, .cutoff_Hz = kSlowHand_Hz};

/// One number of a probe's state.
using Coordinate = std::function<double&(ProbeState&)>;

std::vector<Coordinate> coordinates_of_motion() {
  std::vector<Coordinate> all{};
  for (int axis = 0; axis < 3; ++axis) {
    all.emplace_back([axis](ProbeState& probe) -> double& { return probe.position_m[axis]; });
    all.emplace_back([axis](ProbeState& probe) -> double& { return probe.velocity_m_per_s[axis]; });
    all.emplace_back(
        [axis](ProbeState& probe) -> double& { return probe.angular_velocity_rad_per_s[axis]; });
  }
  for (int part = 0; part < 4; ++part) {
    all.emplace_back([part](ProbeState& probe) -> double& { return probe.orientation[part]; });
  }
  return all;
}

void slow_down(std::span<TickRecord> motion, double rate_Hz,
               const std::vector<Coordinate>& coordinates) {
  // q and −q are one orientation; neighbours have to be close for a filter.
  for (std::size_t i = 1; i < motion.size(); ++i) {
    glm::dquat& orientation = motion[i].probe.orientation;
    if (glm::dot(orientation, motion[i - 1].probe.orientation) < 0.0) orientation = -orientation;
  }
  std::vector<double> values(motion.size());
  for (const Coordinate& coordinate : coordinates) {
    for (std::size_t i = 0; i < motion.size(); ++i) values[i] = coordinate(motion[i].probe);
    // The filter would change nothing, as of a handle that does not turn.
    if (std::ranges::adjacent_find(values, std::ranges::not_equal_to{}) == values.end()) continue;
    const std::vector<double> slow = filtered_without_delay(kSlow, rate_Hz, values);
    for (std::size_t i = 0; i < motion.size(); ++i) coordinate(motion[i].probe) = slow[i];
  }
  for (TickRecord& record : motion) {
    record.probe.orientation = glm::normalize(record.probe.orientation);
  }
}

}  // namespace

std::vector<TickRecord> slow_hand(std::span<const TickRecord> records, double rate_Hz) {
  std::vector<TickRecord> slow(records.begin(), records.end());
  const std::vector<Coordinate> coordinates = coordinates_of_motion();
  const auto longest_gap_ns = static_cast<std::int64_t>(kUnbroken_ticks * 1e9 / rate_Hz);
  std::size_t first = 0;
  for (std::size_t i = 1; i <= slow.size(); ++i) {
    const bool continues = i < slow.size() && !slow[i].has(TickFlag::first_of_presentation) &&
                           records[i].probe.time_ns - records[i - 1].probe.time_ns < longest_gap_ns;
    if (continues) continue;
    slow_down(std::span(slow).subspan(first, i - first), rate_Hz, coordinates);
    first = i;
  }
  return slow;
}

}  // namespace asperity
