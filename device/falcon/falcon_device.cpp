// The Novint Falcon.

#include "device/falcon/falcon_device.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <thread>
#include <utility>

#include <glm/geometric.hpp>

#include "analysis/numbers/number_text.h"
#include "device/units_in_use.h"

namespace asperity {
namespace {

using falcon::FalconLine;

constexpr double kMiddle_m = 0.115;
// Slower than this, a device is what it was measured to be; otherwise it is what it is sold as.
constexpr double kFullRate_Hz = 1000.0;
constexpr double kNearlyFullRate_Hz = 800.0;

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
  // From its lengths and its motors' words (falcon/falcon_kinematics.h), as every pose can be reached and every
  // direction be pushed; it is sold as 4 by 4 by 4 inches and 2 lbf.
  constexpr double kHalf_m = 0.040;
  constexpr double kAnyDirectionInTheMiddle_N = 6.6;
  return {
      .name = "falcon",
      .model = "Novint Falcon",
      .workspace_minimum_m = glm::dvec3(-kHalf_m),
      .workspace_maximum_m = glm::dvec3(kHalf_m),
      .peak_force_N = kAnyDirectionInTheMiddle_N,
      .position_resolution_m = 38e-6,
      .maximum_rate_Hz = kFullRate_Hz,
      .buttons = 4,
      .remarks =
          "Workspace and force are computed from the leg lengths and the motor constant that "
          "open-source drivers use. The workspace is the largest cube that the legs can reach; the "
          "force is that available in every direction at the centre of the cube; at its "
          "corners it is 3.8 N. The manufacturer states ±51 mm and 8.9 N."};
}

std::unique_ptr<FalconDevice> FalconDevice::open(const FalconSettings& settings) {
  std::unique_ptr<FalconDevice> device(
      new FalconDevice(std::make_unique<FalconLine>(settings.line, settings.stop)));
  device->wait_until_homed(settings);
  return device;
}

FalconDevice::FalconDevice(std::unique_ptr<FalconLine> line)
    : HapticDevice(capability_of(*line), ForceLimits{}), line_(std::move(line)) {}

FalconDevice::~FalconDevice() { zero_force(); }

void FalconDevice::wait_until_homed(const FalconSettings& settings) {
  // The bus keeps them off this one.
  const LetOthersLook meanwhile(settings.alone);
  const std::int64_t until_ns =
      line_->now_ns() + std::chrono::nanoseconds(settings.homing_patience).count();
  bool told = false;
  for (;;) {
    falcon::require_no_stop(settings.stop);
    if (line_->take(reading_)) {
      if (reading_.is_homed) {
        state_.store(State::well, std::memory_order_relaxed);
        return;
      }
      if (!told && settings.tell) {
        settings.tell(
            "The Falcon has to be homed: pull the grip out all the way, then push it in all the "
            "way, until its lamp turns from red to green.");
      }
      told = true;
    }
    if (line_->now_ns() > until_ns) {
      throw std::runtime_error(
          told ? "the Falcon was not homed in time: open it again, then pull the grip out all the "
                 "way and push it in all the way until its lamp turns green"
               : "the Falcon stopped responding while it was opened; unplug it and plug it in "
                 "again");
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

FalconDevice::State FalconDevice::state_at(std::int64_t clock_ns) const noexcept {
  // First: plugged in again, it has another watchdog.
  if (!line_->is_connected()) return State::unplugged;
  if (!line_->is_watched()) return State::unwatched;
  if (clock_ns - reading_.time_ns > kLongestSilence_ns) return State::silent;
  return reading_.is_homed ? State::well : State::not_homed;
}

bool FalconDevice::do_read(std::int64_t, ProbeState& state) noexcept {
  if (!line_->take(reading_)) read_again();
  state_.store(state_at(line_->now_ns()), std::memory_order_relaxed);
  state.position_m = from_machine(reading_.position_m - kOrigin_m);
  state.velocity_m_per_s = from_machine(reading_.velocity_m_per_s);
  state.buttons = reading_.buttons;
  return state_.load(std::memory_order_relaxed) == State::well;
}

bool FalconDevice::do_send(const Wrench& limited) noexcept {
  const bool answers = state_.load(std::memory_order_relaxed) == State::well;
  if (!answers || limited.force_N == glm::dvec3(0.0)) {
    line_->command({});
    return answers;
  }
  const std::optional<glm::dvec3> torques = falcon::torques_N_m(
      reading_.plausible.angles, reading_.plausible.position_m, to_machine(limited.force_N));
  const falcon::MotorWords motors =
      torques ? falcon::words_for(*torques) : falcon::MotorWords{.words = {}, .part = 0.0};
  line_->command(motors.words);
  if (motors.part < 1.0) gave_only({.force_N = motors.part * limited.force_N});
  return true;
}

// The thread of the line sends it with its next frame.
void FalconDevice::zero_force_from_outside() noexcept { line_->command({}); }

std::string FalconDevice::trouble() const {
  const std::string it =
      "The Novint Falcon" + (capability().serial.empty() ? "" : " " + capability().serial);
  switch (state_.load(std::memory_order_relaxed)) {
    case State::well:
      return {};
    case State::unwatched:
      return it + " receives no force: " + kWatchdogIsGone +
             ". Unplug the Falcon and plug it in again, or end the session and open the device "
             "again.";
    case State::unplugged:
      return it + " is unplugged: plug it into the same socket again, and check that it has power.";
    case State::silent:
      return it + " has not responded for 50 ms: check its cable.";
    case State::not_homed:
      return it +
             " has to be homed: pull the grip out all the way, then push it in all the way, until "
             "its lamp turns from red to green.";
  }
  return {};
}

Driver falcon_driver() {
  return {.id = "falcon",
          .name = "Novint Falcon",
          .summary = "Novint Falcon: three degrees of freedom with force, over USB.",
          .velocity = falcon::LineSettings{}.velocity,
          .position_step_m = falcon_capability().position_resolution_m,
          .find =
              [](const DriverOptions& options) {
                DriverSurvey survey{};
                std::string unfit{};  // why the firmware that was named cannot be loaded
                try {
                  if (!options.firmware.empty()) {
                    const std::size_t bytes = falcon::read_firmware(options.firmware).size();
                    survey.found = "firmware of " + counted(bytes, "byte", "bytes") + " in " +
                                   options.firmware.string();
                  }
                } catch (const std::exception& error) {
                  unfit = error.what();
                }
                try {
                  const UsbSession usb;
                  survey.attached = falcon::attached_falcons(usb);
                  for (AttachedDevice& one : survey.attached) {
                    if (!one.is_usable()) continue;
                    if (!unfit.empty()) {
                      one.blocker = unfit;  // whatever runs on it: opening refuses such a file
                    } else if (!falcon::runs_firmware(usb, one.place, options.stop)) {
                      if (options.firmware.empty()) {
                        one.blocker = falcon::no_firmware_sentence(one.place);
                      } else {
                        one.remark = "Its firmware is loaded when it is opened.";
                      }
                    }
                  }
                } catch (const std::exception& error) {
                  survey.blocker = error.what();
                }
                // Told before there is one to load it into: whoever prepares a study has time to mend it.
                if (survey.attached.empty() && survey.blocker.empty()) survey.blocker = unfit;
                return survey;
              },
          .open = [](const std::string& which,
                     const DriverOptions& options) -> std::unique_ptr<HapticDevice> {
            FalconSettings settings{
                .tell = options.tell, .stop = options.stop, .alone = options.alone};
            {
              const UsbSession usb;
              const AttachedDevice device =
                  choose_attached("Novint Falcon", falcon::attached_falcons(usb), which);
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
