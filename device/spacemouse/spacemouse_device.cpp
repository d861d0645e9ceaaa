// A SpaceMouse of 3Dconnexion as a probe: its cap drives, and nobody feels a force.

#include "device/spacemouse/spacemouse_device.h"

#include <array>
#include <cstdio>
#include <exception>

namespace asperity {
namespace {

std::string rounded(double value) {
  std::array<char, 32> digits{};
  std::snprintf(digits.data(), digits.size(), "%g", value);
  return digits.data();
}

DeviceCapability spacemouse_capability(const spacemouse::LineSettings& which,
                                       const spacemouse::RateControlSettings& motion) {
  return {.name = spacemouse::kSpaceMouse,
          .model = which.model,
          .serial = which.serial,
          .sensed_degrees_of_freedom = 6,
          .actuated_degrees_of_freedom = 0,
          .workspace_minimum_m = motion.workspace_minimum_m,
          .workspace_maximum_m = motion.workspace_maximum_m,
          .buttons = 1,
          .remarks =
              "It has no motors: no force is felt. Its cap is a rate control: the speed of the "
              "probe is proportional to the square of the deflection beyond a dead zone of " +
              rounded(100.0 * motion.dead_zone) + " %, up to " +
              rounded(motion.full_speed_m_per_s) + " m/s and " +
              rounded(motion.full_turn_rad_per_s) +
              " rad/s. The speed changes with each report (every 8 to 16 ms). The second button "
              "returns the probe to its home position. The workspace is set by the driver."};
}

}  // namespace

SpaceMouseDevice::SpaceMouseDevice(const spacemouse::LineSettings& which,
                                   const spacemouse::RateControlSettings& motion)
    : HapticDevice(spacemouse_capability(which, motion), ForceLimits{}),
      motion_(motion),
      line_(which) {}

SpaceMouseDevice::State SpaceMouseDevice::heard_at(std::int64_t now_ns,
                                                   bool is_told_anew) noexcept {
  if (motion_.is_overdue(now_ns)) return State::silent;
  const bool was_silent = state_.load(std::memory_order_relaxed) == State::silent;
  return was_silent && !is_told_anew ? State::silent : State::well;
}

bool SpaceMouseDevice::do_read(std::int64_t now_ns, ProbeState& state) noexcept {
  const bool is_connected = line_.is_connected();
  if (!is_connected) motion_.stop();
  motion_.advance(now_ns);  // the way until now belongs to what was known
  spacemouse::CapReport report{};
  bool is_told_anew = false;
  if (line_.take(report)) {
    is_told_anew = report.moved_ns != moved_ns_;
    moved_ns_ = report.moved_ns;
    motion_.take(report);
  }
  const State now = is_connected ? heard_at(now_ns, is_told_anew) : State::unplugged;
  state_.store(now, std::memory_order_relaxed);
  if (now == State::silent) motion_.stop();
  state.position_m = motion_.position_m();
  state.orientation = motion_.orientation();
  state.velocity_m_per_s = motion_.velocity_m_per_s();
  state.angular_velocity_rad_per_s = motion_.angular_velocity_rad_per_s();
  state.buttons = motion_.buttons();
  return now == State::well;
}

bool SpaceMouseDevice::do_send(const Wrench&) noexcept {
  return state_.load(std::memory_order_relaxed) == State::well;
}

std::string SpaceMouseDevice::trouble() const {
  const std::string it =
      "The " + capability().model + (capability().serial.empty() ? "" : " " + capability().serial);
  switch (state_.load(std::memory_order_relaxed)) {
    case State::well:
      return {};
    case State::unplugged:
      return it + " is unplugged: plug it into the same socket again.";
    case State::silent:
      return it +
             " has sent nothing for 50 ms although its cap was not at rest: touch the cap and "
             "release it. Check the cable; a wireless device must be switched on and near its "
             "receiver.";
  }
  return {};
}

Driver spacemouse_driver() {
  return {
      .id = spacemouse::kSpaceMouse,
      .name = "3Dconnexion SpaceMouse",
      .summary = "SpaceMouse of 3Dconnexion: moves and turns the probe; it exerts no force.",
      .has_motors = false,
      .find =
          [](const DriverOptions&) {
            DriverSurvey survey{};
            try {
              survey.attached = spacemouse::attached_spacemice(UsbSession());
            } catch (const std::exception& error) {
              survey.blocker = error.what();
            }
            return survey;
          },
      .open = [](const std::string& which, const DriverOptions&) -> std::unique_ptr<HapticDevice> {
        const AttachedDevice found = choose_attached(
            "SpaceMouse of 3Dconnexion", spacemouse::attached_spacemice(UsbSession()), which);
        return std::make_unique<SpaceMouseDevice>(spacemouse::LineSettings{
            .model = found.model, .serial = found.serial, .place = found.place});
      }};
}

}  // namespace asperity
