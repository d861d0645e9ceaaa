// A mouse or a tablet's pen as a probe: moves, presses, and has no motors.

#include "device/pointer_device.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

#include <glm/common.hpp>

#include "device/refusal.h"

namespace asperity {
namespace {

constexpr double kOmega_rad_per_s = 80.0;

DeviceCapability pointer_capability(const PointerSettings& settings) {
  const glm::dvec2 corner_m(settings.half_width_m, settings.half_length_m);
  return {.name = "mouse",
          .model = "pointer of a window",
          .sensed_degrees_of_freedom = 3,
          .actuated_degrees_of_freedom = 0,
          .workspace_minimum_m = {-corner_m.x, -corner_m.y, -settings.deepest_m},
          .workspace_maximum_m = {corner_m.x, corner_m.y, settings.lift_m},
          .maximum_speed_m_per_s = std::numeric_limits<double>::infinity(),
          .remarks =
              "It has no motors: no force is felt. The probe trails the pointer by 25 ms; its "
              "depth is set by the pressure of a pen, or fixed while a mouse's button is held."};
}

void check_pointer(const PointerSettings& settings) {
  require_positive("half_width_m of the pointer", settings.half_width_m);
  require_positive("half_length_m of the pointer", settings.half_length_m);
  require_positive("deepest_m of the pointer", settings.deepest_m);
  require_positive("lift_m of the pointer", settings.lift_m);
  require_positive("held_pressure of the pointer", settings.held_pressure);
  if (settings.held_pressure > 1.0) {
    refuse("held_pressure of the pointer", settings.held_pressure, "at most 1");
  }
}

}  // namespace

PointerDevice::PointerDevice(LatestValue<PointerSample>& samples, const PointerSettings& settings)
    : HapticDevice(pointer_capability(settings), ForceLimits{}),
      samples_(samples),
      settings_(settings) {
  check_pointer(settings);
  at_m_.z = aim_m_.z = settings_.lift_m;
}

void PointerDevice::take_aim() noexcept {
  PointerSample sample{};
  if (!samples_.take(sample)) return;
  if (!std::isfinite(sample.position_m.x + sample.position_m.y + sample.pressure)) return;
  const double pressure = std::clamp(
      sample.is_held ? std::max(sample.pressure, settings_.held_pressure) : sample.pressure, 0.0,
      1.0);
  const glm::dvec2 corner_m(settings_.half_width_m, settings_.half_length_m);
  const glm::dvec2 place_m = glm::clamp(sample.position_m, -corner_m, corner_m);
  aim_m_ = glm::dvec3(place_m, pressure > 0.0 ? -settings_.deepest_m * pressure : settings_.lift_m);
  if (!has_aimed_) {
    // It comes from nowhere, and from above.
    at_m_ = glm::dvec3(place_m, settings_.lift_m);
    has_aimed_ = true;
  }
}

bool PointerDevice::do_read(std::int64_t now_ns, ProbeState& state) noexcept {
  // The way until now belongs to the aim that was known.
  const double since_s =
      has_read_ ? 1e-9 * static_cast<double>(std::max(std::int64_t{0}, now_ns - last_ns_)) : 0.0;
  last_ns_ = has_read_ ? std::max(last_ns_, now_ns) : now_ns;
  has_read_ = true;
  const double left = std::exp(-kOmega_rad_per_s * since_s);
  const glm::dvec3 off_m = at_m_ - aim_m_;
  const glm::dvec3 rate_m_per_s = velocity_m_per_s_ + kOmega_rad_per_s * off_m;
  at_m_ = aim_m_ + left * (off_m + since_s * rate_m_per_s);
  velocity_m_per_s_ = left * (velocity_m_per_s_ - kOmega_rad_per_s * since_s * rate_m_per_s);
  take_aim();
  state.position_m = at_m_;
  state.velocity_m_per_s = velocity_m_per_s_;
  return true;
}

Driver pointer_driver() {
  return {
      .id = "mouse",
      .name = "Mouse or tablet",
      .summary = "Mouse or tablet in a window: moves and presses the probe; it exerts no force.",
      .has_motors = false,
      .find =
          [](const DriverOptions& options) {
            DriverSurvey survey{};
            if (options.pointer == nullptr) {
              survey.blocker =
                  "It receives its input from a window, and there is none here: run the session in "
                  "the program's windows.";
            } else {
              survey.attached.push_back({.model = "pointer of a window"});
            }
            return survey;
          },
      .open = [](const std::string&,
                 const DriverOptions& options) -> std::unique_ptr<HapticDevice> {
        if (options.pointer == nullptr) {
          throw std::runtime_error(
              "the device \"mouse\" receives its input from a window, and there is none; "
              "choose another device");
        }
        return std::make_unique<PointerDevice>(*options.pointer);
      }};
}

}  // namespace asperity
