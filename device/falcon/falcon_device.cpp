// The Novint Falcon.

#include "device/falcon/falcon_device.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <thread>
#include <utility>

#include <glm/geometric.hpp>

namespace asperity {
namespace {

using falcon::FalconLine;

constexpr double kMiddle_m = 0.115;
constexpr std::int64_t kOldest_ns = 50'000'000;
constexpr double kStrongPush_N = 2.0;
constexpr std::int64_t kLongPush_ns = 1'000'000'000;
// Slower than this, a device is what it was measured to be; otherwise it is what it is sold as.
constexpr double kFullRate_Hz = 1000.0;
constexpr double kNearlyFullRate_Hz = 800.0;

std::int64_t monotonic_ns() noexcept {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

DeviceCapability capability_of(const FalconLine& line) {
  DeviceCapability capability = falcon_capability();
  capability.serial = line.settings().serial;
  if (line.rate_Hz() <= kNearlyFullRate_Hz) capability.maximum_rate_Hz = std::floor(line.rate_Hz());
  return capability;
}

// The machine's z points to the hand, and its y up.
glm::dvec3 from_machine(const glm::dvec3& v) noexcept { return {v.x, -v.z, v.y}; }
glm::dvec3 to_machine(const glm::dvec3& v) noexcept { return {v.x, v.z, -v.y}; }
constexpr glm::dvec3 kOrigin_m{0.0, 0.0, kMiddle_m};

}  // namespace

DeviceCapability falcon_capability() {
  constexpr double kHalf_m = 0.0508;  // 4 inches each way, as published
  return {.name = "falcon",
          .model = "Novint Falcon",
          .workspace_minimum_m = glm::dvec3(-kHalf_m),
          .workspace_maximum_m = glm::dvec3(kHalf_m),
          .peak_force_N = 8.9,  // 2 lbf, as published; less where the motors are at their limit
          .position_resolution_m = 38e-6,
          .maximum_rate_Hz = kFullRate_Hz,
          .buttons = 4};
}

std::unique_ptr<FalconDevice> FalconDevice::open(const FalconSettings& settings) {
  std::unique_ptr<FalconDevice> device(
      new FalconDevice(std::make_unique<FalconLine>(settings.line)));
  device->wait_until_homed(settings);
  return device;
}

FalconDevice::FalconDevice(std::unique_ptr<FalconLine> line)
    : HapticDevice(capability_of(*line), ForceLimits{}), line_(std::move(line)) {}

FalconDevice::~FalconDevice() { zero_force(); }

void FalconDevice::wait_until_homed(const FalconSettings& settings) {
  const auto until = std::chrono::steady_clock::now() + settings.homing_patience;
  bool told = false;
  for (;;) {
    if (line_->take(reading_)) {
      if (reading_.is_homed) return;
      if (!told && settings.tell) {
        settings.tell(
            "The Falcon looks for its zero: pull the grip out all the way, then push it in all the "
            "way, until its lamp turns from red to green.");
      }
      told = true;
    }
    if (std::chrono::steady_clock::now() > until) {
      throw std::runtime_error(
          told
              ? "the Falcon was not homed in time: open it again, then pull the grip out all the "
                "way and push it in all the way until its lamp turns green"
              : "the Falcon stopped answering while it was opened; unplug it and plug it in again");
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

bool FalconDevice::answers(std::int64_t clock_ns) noexcept {
  if (!line_->is_connected() || !reading_.is_homed) return false;
  if (clock_ns - reading_.time_ns > kOldest_ns) return false;
  if (stuck_since_ns_ != 0) {
    if (reading_.moved_ns <= stuck_since_ns_) return false;
    stuck_since_ns_ = 0;
  }
  if (pushes_ && clock_ns - std::max(pushes_since_ns_, reading_.moved_ns) > kLongPush_ns) {
    stuck_since_ns_ = reading_.moved_ns;
    return false;
  }
  return true;
}

bool FalconDevice::do_read(std::int64_t, ProbeState& state) noexcept {
  line_->take(reading_);
  answers_ = answers(monotonic_ns());
  state.position_m = from_machine(reading_.position_m - kOrigin_m);
  state.velocity_m_per_s = from_machine(reading_.velocity_m_per_s);
  state.buttons = reading_.buttons;
  return answers_;
}

bool FalconDevice::do_send(const Wrench& limited) noexcept {
  const double strength_N = glm::length(limited.force_N);
  const bool pushes = strength_N > kStrongPush_N;
  if (pushes && !pushes_) pushes_since_ns_ = monotonic_ns();
  pushes_ = pushes;
  if (!answers_ || strength_N == 0.0) {
    line_->command({});
    return answers_;
  }
  const std::optional<glm::dvec3> torques =
      falcon::torques_N_m(reading_.angles, reading_.position_m, to_machine(limited.force_N));
  const falcon::MotorWords motors =
      torques ? falcon::words_for(*torques) : falcon::MotorWords{.words = {}, .part = 0.0};
  line_->command(motors.words);
  if (motors.part < 1.0) gave_only({.force_N = motors.part * limited.force_N});
  return true;
}

Driver falcon_driver() {
  return {.id = "falcon",
          .summary = "Novint Falcon: three degrees of freedom with force, over USB.",
          .find =
              [](const DriverOptions& options) {
                DriverSurvey survey{};
                try {
                  const falcon::UsbSession usb;
                  survey.attached = usb.falcons();
                  for (AttachedDevice& one : survey.attached) {
                    if (one.is_usable() && !falcon::runs_firmware(usb, one.place)) {
                      if (options.firmware.empty()) {
                        one.hindrance = falcon::no_firmware_sentence(one.place);
                      } else {
                        one.remark = "Its firmware is loaded when it is opened.";
                      }
                    }
                  }
                } catch (const std::exception& error) {
                  survey.hindrance = error.what();
                }
                return survey;
              },
          .open = [](const std::string& which,
                     const DriverOptions& options) -> std::unique_ptr<HapticDevice> {
            FalconSettings settings{.tell = options.tell};
            {
              const falcon::UsbSession usb;
              const AttachedDevice device = choose_attached("Novint Falcon", usb.falcons(), which);
              settings.line.place = device.place;
              settings.line.serial = device.serial;
            }
            if (!options.firmware.empty()) {
              settings.line.firmware = falcon::read_firmware(options.firmware);
            }
            settings.line.wants_fifo = options.wants_fifo;
            return FalconDevice::open(settings);
          }};
}

}  // namespace asperity
