// A recording as a hand.

#include "device/replay_device.h"

#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include <glm/common.hpp>

namespace asperity {
namespace {

// Both an input device without limits of its own and the box that its recording fills.
DeviceCapability recorded_capability(const std::vector<ProbeState>& states,
                                     const std::string& source) {
  if (states.empty())
    throw std::invalid_argument("the replayed hand has no states; it needs at least one");
  DeviceCapability capability{
      .name = "replay", .model = "recording", .actuated_degrees_of_freedom = 0};
  capability.sensed_degrees_of_freedom = 6;
  capability.maximum_rate_Hz = 10'000.0;
  capability.maximum_speed_m_per_s = std::numeric_limits<double>::infinity();
  capability.remarks = "It has no motors: no force is felt. The hand repeats the movement of " +
                       (source.empty() ? "a recording" : "the recording " + source) +
                       " from its first tick in each attempt, and rests where the recording ends.";
  capability.workspace_minimum_m = states.front().position_m;
  capability.workspace_maximum_m = states.front().position_m;
  std::uint32_t buttons = 0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (i > 0 && states[i].time_ns <= states[i - 1].time_ns) {
      throw std::invalid_argument("time_ns of state " + std::to_string(i) +
                                  " of a replayed hand is " + std::to_string(states[i].time_ns) +
                                  "; it must be later than the one before");
    }
    capability.workspace_minimum_m = glm::min(capability.workspace_minimum_m, states[i].position_m);
    capability.workspace_maximum_m = glm::max(capability.workspace_maximum_m, states[i].position_m);
    buttons |= states[i].buttons;
  }
  while (buttons != 0) {
    ++capability.buttons;
    buttons >>= 1U;
  }
  return capability;
}

}  // namespace

ReplayDevice::ReplayDevice(std::vector<ProbeState> states, ReplayEnd end, const std::string& source)
    : HapticDevice(recorded_capability(states, source), ForceLimits{}),
      states_(std::move(states)),
      end_(end) {}

bool ReplayDevice::do_read(std::int64_t now_ns, ProbeState& state) noexcept {
  if (begins_.exchange(false) || !has_begun_) {
    has_begun_ = true;
    at_ = 0;
    began_ns_ = now_ns;
  }
  const std::int64_t due_ns = states_.front().time_ns + (now_ns - began_ns_);
  const bool rests = at_ + 1 == states_.size() && due_ns > states_.back().time_ns;
  while (at_ + 1 < states_.size() && states_[at_ + 1].time_ns <= due_ns) ++at_;
  is_over_ = at_ + 1 == states_.size();
  state = states_[at_];
  state.time_ns = now_ns;
  if (rests) {
    state.velocity_m_per_s = glm::dvec3(0.0);
    state.angular_velocity_rad_per_s = glm::dvec3(0.0);
    state.buttons = 0;
  }
  is_lost_ = rests && end_ == ReplayEnd::lost;
  return !is_lost_;
}

Driver replay_driver() {
  return {
      .id = "replay",
      .name = "Recorded hand",
      .summary = "A recorded hand: repeats recorded movements; it exerts no force.",
      .has_motors = false,
      .find =
          [](const DriverOptions&) {
            return DriverSurvey{.blocker = "It replays a recording: name its file, replay:FILE."};
          },
      .open = [](const std::string& file,
                 const DriverOptions& options) -> std::unique_ptr<HapticDevice> {
        if (file.empty()) {
          throw std::runtime_error(
              "the device \"replay\" is a recorded hand: name the recording, replay:FILE (those of "
              "a study are in its folder recordings)");
        }
        if (!options.recorded_hand) {
          throw std::runtime_error(
              "the device \"replay\" cannot be used here; run a session on it");
        }
        return std::make_unique<ReplayDevice>(options.recorded_hand(file), ReplayEnd::rest, file);
      }};
}

}  // namespace asperity
