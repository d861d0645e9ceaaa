// A Touch or Phantom of 3D Systems, through OpenHaptics.

#include "device/openhaptics/openhaptics_device.h"

#include <atomic>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <thread>
#include <utility>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>

#include "device/call_gate.h"
#include "device/small_turn.h"
#include "device/units_in_use.h"
#include "device/velocity_estimator.h"

namespace asperity {
namespace {

constexpr double kMillimetre_m = 1e-3;
constexpr double kTorqueUnits_per_N_m = 1e3;  // newton millimetres
constexpr double kUsualRate_Hz = 1000.0;      // of its scheduler, unless told otherwise
constexpr VelocityWindow kVelocityWindow{.samples =
                                             5};  // 2 ms late, as for every maker's device here
constexpr const char* kOpenHaptics = "openhaptics";
// How many frames without an error it takes before the last one is no news any more: two seconds' worth.
constexpr int kFramesToForget = 2000;

// libHD's y is up and its z towards the participant; ours are away from them and up.
glm::dvec3 hd_to_ours(const glm::dvec3& theirs) noexcept { return {theirs.x, -theirs.z, theirs.y}; }
glm::dvec3 ours_to_hd(const glm::dvec3& ours) noexcept { return {ours.x, ours.z, -ours.y}; }

// The same turn, told in our axes: C·R·Cᵀ, where the rows of C are our axes in theirs.
glm::dquat hd_orientation(const double (&transform)[16]) noexcept {
  const auto column = [&transform](int j) {
    return hd_to_ours({transform[4 * j], transform[4 * j + 1], transform[4 * j + 2]});
  };
  return glm::quat_cast(glm::dmat3(column(0), -column(2), column(1)));
}

std::string text_of(const HdFunctions& hd, unsigned int what) {
  const char* text = hd.hdGetString(what);
  return text == nullptr ? "" : text;
}

}  // namespace

struct OpenHapticsDevice::Opened {
  unsigned int handle = HdFunctions::kNoDevice;
  DeviceCapability capability{};
  glm::dvec3 centre_m{0.0};  // of the usable workspace, in our axes
  std::string place{};       // the name under which it is configured
};

// Outlives the device where libHD's thread does not come to an end.
struct OpenHapticsDevice::Servo {
  std::shared_ptr<const HdFunctions> hd;
  unsigned int handle = 0;
  bool has_torque = false;
  glm::dvec3 centre_m{0.0};
  UnitInUse in_use;
  CallGate gate{};

  Servo(std::shared_ptr<const HdFunctions> the_hd, const Opened& opened)
      : hd(std::move(the_hd)),
        handle(opened.handle),
        has_torque(opened.capability.actuated_degrees_of_freedom >= 6),
        centre_m(opened.centre_m),
        in_use(kOpenHaptics, {.model = opened.capability.model,
                              .serial = opened.capability.serial,
                              .place = opened.place}) {}

  // libHD's thread.
  double transform[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  int buttons = 0;
  bool was_read = false;
  bool may_push = false;
  unsigned int error_at_end = 0;  ///< of the frame before
  Wrench wanted{};
  VelocityEstimator velocity{kVelocityWindow};
  VelocityEstimator angular_velocity{kVelocityWindow, kFastestTurn_rad_per_s};
  glm::dvec3 turned_rad{0.0};
  glm::dquat last_orientation{1.0, 0.0, 0.0, 0.0};

  std::atomic<bool> has_begun{false};        ///< its first frame
  std::atomic<bool> is_done{false};          ///< its last call was answered with "no more"
  std::atomic<bool> is_switched_off{false};  ///< its force output, because a tick did not return
  std::atomic<unsigned int> last_error{0};
  std::atomic<int> frames_since_error{0};

  static unsigned int frame(void* servo) { return static_cast<Servo*>(servo)->run_frame(); }

  // No thread runs frames.
  void begin_anew() noexcept {
    was_read = false;
    may_push = false;
    error_at_end = 0;
    wanted = Wrench{};
    has_begun.store(false);
    is_done.store(false);
    is_switched_off.store(false);
    last_error.store(0);
    velocity.reset();
    angular_velocity.reset();
  }

  unsigned int run_frame() noexcept {
    has_begun.store(true, std::memory_order_relaxed);
    hd->hdMakeCurrentDevice(handle);
    hd->hdBeginFrame(handle);
    hd->hdGetDoublev(HdFunctions::kTransform, transform);
    hd->hdGetIntegerv(HdFunctions::kButtons, &buttons);
    const unsigned int error_at_begin = note(hd->take_errors());
    was_read = error_at_begin == 0 || HdFunctions::is_about_force(error_at_begin);
    // Nothing is pushed in the frame in which an error is told, whichever it is, nor after one at a frame's end.
    may_push = error_at_begin == 0 && error_at_end == 0;

    wanted = Wrench{};
    const bool was_wanted = gate.pass();
    // A tick may have pushed a force that it computed before the force was switched off.
    const bool was_switched_off = is_switched_off.load();
    send(may_push && !was_switched_off ? wanted : Wrench{});
    hd->hdEndFrame(handle);
    error_at_end = note(hd->take_errors());
    if (error_at_begin == 0 && error_at_end == 0 &&
        frames_since_error.load(std::memory_order_relaxed) < kFramesToForget) {
      frames_since_error.fetch_add(1, std::memory_order_relaxed);
    }
    if (was_wanted) {
      // Only after a frame at zero force.
      if (was_switched_off) {
        is_switched_off.store(false);
        hd->hdEnable(HdFunctions::kForceOutput);
      }
      return HdFunctions::kContinue;
    }
    is_done.store(true, std::memory_order_release);
    return HdFunctions::kDone;
  }

  unsigned int note(const HdFunctions::Error& error) noexcept {
    if (error.code != 0) {
      last_error.store(error.code, std::memory_order_relaxed);
      frames_since_error.store(0, std::memory_order_relaxed);
    }
    return error.code;
  }

  void send(const Wrench& wrench) const noexcept {
    const glm::dvec3 force_N = ours_to_hd(wrench.force_N);
    hd->hdSetDoublev(HdFunctions::kForce, &force_N.x);
    if (!has_torque) return;
    const glm::dvec3 torque = kTorqueUnits_per_N_m * ours_to_hd(wrench.torque_N_m);
    hd->hdSetDoublev(HdFunctions::kTorque, &torque.x);
  }
};

OpenHapticsDevice::Opened OpenHapticsDevice::open(const HdFunctions& hd, const std::string& name) {
  const std::string who = name.empty() ? "the default device of OpenHaptics"
                                       : "the device \"" + name + "\" of OpenHaptics";
  hd.take_errors();  // what is on the stack is not ours
  Opened opened{.handle = hd.hdInitDevice(name.empty() ? nullptr : name.c_str()),
                .place = name.empty() ? "default" : name};
  const HdFunctions::Error error = hd.take_errors();
  if (opened.handle == HdFunctions::kNoDevice || error.code != 0) {
    throw std::runtime_error(
        who + " cannot be opened: " + hd.name_of(error) +
        ". Check that it is configured under this name with its manufacturer's setup program.");
  }
  hd.hdMakeCurrentDevice(opened.handle);
  DeviceCapability& capability = opened.capability;
  capability.name = "openhaptics";
  capability.model = text_of(hd, HdFunctions::kModel);
  capability.serial = text_of(hd, HdFunctions::kSerial);
  capability.pacing = Pacing::theirs;
  capability.buttons = 2;
  capability.maximum_rate_Hz = kUsualRate_Hz;
  hd.hdGetIntegerv(HdFunctions::kSensedDegrees, &capability.sensed_degrees_of_freedom);
  hd.hdGetIntegerv(HdFunctions::kActuatedDegrees, &capability.actuated_degrees_of_freedom);
  hd.hdGetDoublev(HdFunctions::kPeakForce, &capability.peak_force_N);
  hd.hdGetDoublev(HdFunctions::kContinuousForce, &capability.continuous_force_N);
  double box_mm[6] = {};
  hd.hdGetDoublev(HdFunctions::kUsableWorkspace, box_mm);
  const glm::dvec3 one = kMillimetre_m * hd_to_ours({box_mm[0], box_mm[1], box_mm[2]});
  const glm::dvec3 other = kMillimetre_m * hd_to_ours({box_mm[3], box_mm[4], box_mm[5]});
  opened.centre_m = 0.5 * (one + other);
  capability.workspace_minimum_m = glm::min(one, other) - opened.centre_m;
  capability.workspace_maximum_m = glm::max(one, other) - opened.centre_m;
  capability.remarks =
      "Forces and workspace are those that the device reports; its resolution is unknown. The "
      "position is that of the gimbal's centre. Velocity is the slope of the last five positions. "
      "The manufacturer's scheduler is the timing source, and its clamping of forces is on.";

  unsigned int calibration = hd.hdCheckCalibration();
  int styles = 0;
  hd.hdGetIntegerv(HdFunctions::kCalibrationStyle, &styles);
  const unsigned int style =
      static_cast<unsigned int>(styles) & (HdFunctions::kByItself | HdFunctions::kInInkwell);
  if (calibration == HdFunctions::kNeedsUpdate && style != 0) {
    hd.hdUpdateCalibration((style & HdFunctions::kByItself) != 0 ? HdFunctions::kByItself : style);
    calibration = hd.hdCheckCalibration();
  }
  std::string refusal;
  if (const HdFunctions::Error asked = hd.take_errors(); asked.code != 0) {
    refusal = "it does not report its properties: " + hd.name_of(asked) +
              ". Check its power and its cable";
  } else if (calibration != HdFunctions::kCalibrated) {
    refusal =
        "it is not calibrated. Put the stylus into its inkwell, or calibrate it with its "
        "manufacturer's program";
  } else if (!(std::isfinite(capability.peak_force_N) && capability.peak_force_N > 0.0)) {
    refusal =
        "it does not report its peak force, without which forces cannot be limited. Use another "
        "device";
  }
  if (!refusal.empty()) {
    hd.hdDisableDevice(opened.handle);
    throw std::runtime_error(who + " cannot be used: " + refusal + ".");
  }
  return opened;
}

OpenHapticsDevice::OpenHapticsDevice(std::shared_ptr<const HdFunctions> hd, const std::string& name,
                                     std::chrono::milliseconds patience)
    : OpenHapticsDevice(hd, open(*hd, name), patience) {}

OpenHapticsDevice::OpenHapticsDevice(std::shared_ptr<const HdFunctions> hd, const Opened& opened,
                                     std::chrono::milliseconds patience)
    : HapticDevice(opened.capability, ForceLimits{}),
      hd_(std::move(hd)),
      patience_(patience),
      servo_(std::make_unique<Servo>(hd_, opened)) {}

OpenHapticsDevice::~OpenHapticsDevice() {
  stop_calls();
  if (is_given_up_) {
    // Another word to libHD would hang as well, and its thread may still look at this.
    [[maybe_unused]] Servo* left_behind = servo_.release();
    return;
  }
  switch_off();
  hd_->hdDisableDevice(servo_->handle);
}

void OpenHapticsDevice::start_calls(const TickCall& call) {
  if (is_given_up_) {
    throw std::runtime_error("OpenHaptics' thread hangs: end this program and start it again.");
  }
  if (is_called_)
    throw std::logic_error(
        "the calls of the device openhaptics have already begun; call stop_calls first");
  const auto refuse_after = [this](const std::string& what) {
    if (const HdFunctions::Error error = hd_->take_errors(); error.code != 0) {
      throw std::runtime_error("OpenHaptics cannot " + what + ": " + hd_->name_of(error) +
                               ". Open the device again.");
    }
  };
  hd_->take_errors();
  hd_->hdMakeCurrentDevice(servo_->handle);
  servo_->begin_anew();
  try {
    if (call.rate_Hz != kUsualRate_Hz) {
      hd_->hdSetSchedulerRate(static_cast<unsigned long>(std::lround(call.rate_Hz)));
      refuse_after("run at " + std::to_string(std::lround(call.rate_Hz)) + " Hz");
      has_other_rate_ = true;
    }
    hd_->hdEnable(HdFunctions::kForceOutput);
    hd_->hdEnable(HdFunctions::kForceClamping);
    refuse_after("switch on the force of the device");
    servo_->gate.open(call);
    schedule_ =
        hd_->hdScheduleAsynchronous(&Servo::frame, servo_.get(), HdFunctions::kUsualPriority);
    is_called_ = true;
    hd_->hdStartScheduler();
    refuse_after("start its scheduler");
  } catch (...) {
    if (is_called_) end_frames();
    switch_off();
    throw;
  }
}

void OpenHapticsDevice::stop_calls() noexcept {
  if (!is_called_) return;
  // The next frame finds the gate closed, sends zero and says that it needs no other.
  servo_->gate.close();
  const auto until = std::chrono::steady_clock::now() + patience_;
  while (!servo_->is_done.load(std::memory_order_acquire)) {
    if (std::chrono::steady_clock::now() >= until) break;
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
  if (!servo_->is_done.load() && servo_->has_begun.load()) {
    is_called_ = false;
    is_given_up_.store(true);
    return;
  }
  end_frames();
  switch_off();
}

// libHD's thread runs no frame of ours any more, or never began one.
void OpenHapticsDevice::end_frames() noexcept {
  is_called_ = false;
  servo_->gate.close();
  hd_->hdStopScheduler();
  hd_->hdUnschedule(schedule_);
}

void OpenHapticsDevice::switch_off() noexcept {
  hd_->hdMakeCurrentDevice(servo_->handle);
  hd_->hdDisable(HdFunctions::kForceOutput);
  // The scheduler is one for the process: the next to use it finds it as it was.
  if (has_other_rate_) hd_->hdSetSchedulerRate(static_cast<unsigned long>(kUsualRate_Hz));
  has_other_rate_ = false;
  hd_->take_errors();
}

void OpenHapticsDevice::zero_force_from_outside() noexcept {
  // Between two frames no tick keeps a force, and what does not return is libHD, to which this call would not return either.
  if (is_given_up_ || !servo_->gate.is_passing()) return;
  hd_->hdMakeCurrentDevice(servo_->handle);
  hd_->hdDisable(HdFunctions::kForceOutput);
  // Last: a frame that ends in between is followed by one that switches it on.
  servo_->is_switched_off.store(true);
}

bool OpenHapticsDevice::do_read(std::int64_t now_ns, ProbeState& state) noexcept {
  if (is_given_up_ || !servo_->was_read) return false;
  Servo& servo = *servo_;
  const double(&transform)[16] = servo.transform;
  state.position_m =
      kMillimetre_m * hd_to_ours({transform[12], transform[13], transform[14]}) - servo.centre_m;
  state.orientation = hd_orientation(transform);
  state.velocity_m_per_s = servo.velocity.add(now_ns, state.position_m);
  servo.turned_rad += small_turn_rad(servo.last_orientation, state.orientation);
  servo.last_orientation = state.orientation;
  state.angular_velocity_rad_per_s = servo.angular_velocity.add(now_ns, servo.turned_rad);
  state.buttons = static_cast<std::uint32_t>(servo.buttons);
  return true;
}

bool OpenHapticsDevice::do_send(const Wrench& limited) noexcept {
  if (is_given_up_) return false;
  servo_->wanted = limited;  // set in the frame that is under way; none is outside a call
  return servo_->may_push;
}

std::string OpenHapticsDevice::trouble() const {
  const std::string who = capability().model + " " + capability().serial;
  if (is_given_up_.load())
    return "OpenHaptics' thread hangs, and " + who +
           " does not respond: end this program and start it again.";
  const unsigned int code = servo_->last_error.load();
  if (code != 0 && servo_->frames_since_error.load() < kFramesToForget) {
    return who + " reported " + hd_->name_of({.code = code}) + ".";
  }
  if (has_fallen_silent()) {
    return "OpenHaptics' scheduler ran no frame of " + who + " for more than " +
           std::to_string(kLongestSilence_ns / 1'000'000) +
           " ms: check its cable, and that no other program keeps this computer busy. If it still "
           "does not respond, end this program and start it again.";
  }
  return "";
}

Driver openhaptics_driver() {
  return {.id = "openhaptics",
          .name = "3D Systems Touch and Phantom",
          .summary = "Touch and Phantom of 3D Systems, through OpenHaptics.",
          .is_closed_by_another_process = true,
          .velocity = kVelocityWindow,
          .find =
              [](const DriverOptions& options) {
                DriverSurvey survey;
                try {
                  auto hd = std::make_shared<const HdFunctions>(options.library);
                  survey.found = "libHD in " + hd->file().string();
                  // To look at any device is to make it libHD's current one, and to end that is to switch it off.
                  survey.attached = UnitInUse::of(kOpenHaptics);
                  if (!survey.attached.empty()) return survey;
                  AttachedDevice device{.model = "OpenHaptics", .place = "default"};
                  try {
                    const OpenHapticsDevice opened(std::move(hd), "");
                    device.model = opened.capability().model;
                    device.serial = opened.capability().serial;
                  } catch (const std::runtime_error& refusal) {
                    device.blocker = refusal.what();
                  }
                  survey.attached.push_back(device);
                } catch (const std::runtime_error& refusal) {
                  survey.blocker = refusal.what();
                }
                return survey;
              },
          .open = [](const std::string& which,
                     const DriverOptions& options) -> std::unique_ptr<HapticDevice> {
            const auto hd = std::make_shared<const HdFunctions>(options.library);
            if (const auto used = UnitInUse::of(kOpenHaptics); !used.empty()) {
              throw std::runtime_error("This program uses " + used.front().model + " " +
                                       used.front().serial +
                                       ", and it can use only one device of OpenHaptics at a time. "
                                       "Close that device first.");
            }
            if (which.empty() || which == "default")
              return std::make_unique<OpenHapticsDevice>(hd, "");
            try {
              return std::make_unique<OpenHapticsDevice>(hd, which);
            } catch (const std::runtime_error&) {
              // No device has this name; it may be a serial number.
              auto by_serial = [&hd]() -> std::unique_ptr<OpenHapticsDevice> {
                try {
                  return std::make_unique<OpenHapticsDevice>(hd, "");
                } catch (const std::runtime_error&) {
                  return nullptr;
                }
              }();
              if (by_serial != nullptr && by_serial->capability().serial == which) return by_serial;
              throw;
            }
          }};
}

}  // namespace asperity
