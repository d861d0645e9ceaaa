// Converts axes and orientations, watches for stale readings, and reopens a lost device.

#include "device/force_dimension/force_dimension_device.h"

#include <chrono>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>

#include "device/force_dimension/find_zero.h"
#include "device/force_dimension/open_unit.h"
#include "device/small_turn.h"
#include "device/units_in_use.h"

namespace asperity {

using namespace force_dimension;

namespace {

constexpr std::int64_t kLongestStale_ns = 50'000'000;
constexpr std::int64_t kLongestFailure_ns = 200'000'000;
constexpr std::chrono::milliseconds kBetweenTrials(250);
// After this many pushes without saturation, some two seconds, earlier saturation is no longer reported.
constexpr int kPushesToForget = 2000;
constexpr double kGripped_rad = 10.0 * std::numbers::pi / 180.0;
constexpr double kLetGo_rad = 15.0 * std::numbers::pi / 180.0;
constexpr std::uint32_t kGripperButton = 2;  // the bit

// The SDK's x points to the participant and its y to the participant's right; ours point right and away.
glm::dvec3 ours_from(const glm::dvec3& theirs) noexcept { return {theirs.y, -theirs.x, theirs.z}; }
glm::dvec3 theirs_from(const glm::dvec3& ours) noexcept { return {-ours.y, ours.x, ours.z}; }

// The same rotation in our axes: C·R·Cᵀ, where the rows of C are our axes in those of the SDK.
glm::dquat orientation_from(const double (&rows)[3][3]) noexcept {
  const auto column = [&rows](int j) { return ours_from({rows[0][j], rows[1][j], rows[2][j]}); };
  return glm::quat_cast(glm::dmat3(column(1), -column(0), column(2)));
}

// Causes of the SDK for a force that is off.
constexpr int kByButton = 1;
constexpr int kByVelocityGuard = 2;
constexpr int kByDeadman = 6;

// The user, or a guard against an action of the user, switched the force off: only the user may switch it on again.
bool is_for_people(int cause) noexcept {
  return cause == kByButton || cause == kByVelocityGuard || cause == kByDeadman;
}

std::string cause_of(int cause) {
  switch (cause) {
    case kByButton:
      return "its force button was pressed; press it again";
    case kByVelocityGuard:
      return "its velocity guard has tripped: the handle was moved faster than its manufacturer "
             "allows. Press the force button";
    case 3:
      return "its watchdog has tripped: it received no force for too long. Press the force button";
    case 4:
      return "a program has switched it off. Press the force button";
    case 5:
      return "its USB connection was lost. Check its cable";
    case kByDeadman:
      return "its handle is not held. Hold it";
    default:
      return "the device does not report the cause. Press the force button";
  }
}

}  // namespace

struct ForceDimensionDevice::Opened {
  Identity identity{};
  DhdModel model{};
};

ForceDimensionDevice::ForceDimensionDevice(std::shared_ptr<const DhdFunctions> sdk, int index,
                                           const MayMove& may_move, const std::stop_token& stop,
                                           const Tell& tell)
    : ForceDimensionDevice(sdk, [&sdk, index, &may_move, &stop, &tell] {
        Opened opened{.identity = open_index(*sdk, index)};
        try {
          std::optional<DhdModel> model = dhd_model_of(opened.identity.type);
          if (!model) throw std::runtime_error(unknown_type(opened.identity.type));
          opened.model = *std::move(model);
          find_zero(*sdk, opened.identity, opened.model.capability.model, may_move, stop, tell);
          if (!set_zero_force(*sdk, opened.identity.id) ||
              sdk->dhdEnableForce(1, opened.identity.id) < 0) {
            throw std::runtime_error(
                "the force of " + opened.model.capability.model + " " + opened.identity.serial +
                " cannot be switched on: " + last_error_of(*sdk) + ". Check that it has power.");
          }
        } catch (...) {
          if (opened.identity.is_robotic) sdk->dhdStop(opened.identity.id);
          close_device(*sdk, opened.identity);
          throw;
        }
        return opened;
      }()) {}

ForceDimensionDevice::ForceDimensionDevice(std::shared_ptr<const DhdFunctions> sdk,
                                           const Opened& opened)
    : HapticDevice(
          [&opened, &sdk] {
            DeviceCapability capability = opened.model.capability;
            capability.serial = opened.identity.serial;
            if (sdk->dhdGetGripperAngleRad == nullptr) capability.buttons = 1;
            return capability;
          }(),
          ForceLimits{}),
      sdk_(std::move(sdk)),
      id_(opened.identity.id),
      is_robotic_(opened.identity.is_robotic),
      type_(opened.identity.type),
      has_wrist_(opened.model.has_wrist),
      has_gripper_(opened.model.has_gripper && sdk_->dhdGetGripperAngleRad != nullptr),
      in_use_(kDriver, {.model = capability().model,
                        .serial = capability().serial,
                        .place = place_of(opened.identity.index)}) {
  keeper_ = std::thread([this] { keep(); });
}

ForceDimensionDevice::~ForceDimensionDevice() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  wake_.notify_all();
  keeper_.join();
  if (is_closed_) return;
  is_given_up_.store(false);
  zero_force();
  sdk_->dhdStop(id_);
  close_device(*sdk_, {.id = id_, .is_robotic = is_robotic_});
}

void ForceDimensionDevice::keep() {
  std::unique_lock lock(mutex_);
  while (!wake_.wait_for(lock, kBetweenTrials, [this] { return ends_; })) {
    if (!is_given_up_.load(std::memory_order_acquire)) continue;
    if (!is_closed_) close_device(*sdk_, {.id = id_, .is_robotic = is_robotic_});
    is_closed_ = true;
    // While devices are searched for or one is opened, the next trial follows.
    const std::unique_lock alone(UnitInUse::looking(), std::try_to_lock);
    if (!alone.owns_lock() || !reopen()) continue;
    is_closed_ = false;
    is_given_up_.store(false, std::memory_order_release);
  }
}

// Opens the device with our serial number, at any place. Its ID.
std::optional<char> ForceDimensionDevice::find_again() {
  const std::string& serial = capability().serial;
  if (sdk_->dhdOpenSerial != nullptr && !serial.empty()) {
    const int id = sdk_->dhdOpenSerial(std::stoi(serial));
    if (id >= 0) return static_cast<char>(id);
  }
  // Without a search by serial number each device has to be opened to read its number, which must not happen while one
  // is used.
  const int count = sdk_->dhdGetDeviceCount();
  const bool all_are_free = sdk_->dhdGetAvailableCount != nullptr &&
                            sdk_->dhdGetAvailableCount() >= count &&
                            UnitInUse::of(kDriver).size() == 1;
  if (!all_are_free || (serial.empty() && count != 1)) return std::nullopt;
  for (int index = 0; index < count; ++index) {
    const int id = sdk_->dhdOpenID(static_cast<char>(index));
    if (id < 0) continue;  // not ready yet
    const Identity identity = identity_of(*sdk_, index, id);
    if (identity.serial == serial && identity.type == type_) return identity.id;
    sdk_->dhdClose(identity.id);
  }
  return std::nullopt;
}

bool ForceDimensionDevice::reopen() {
  const std::optional<char> id = find_again();
  if (!id) {
    has_lost_zero_.store(false);  // it was there for a moment only
    return false;
  }
  int status[DhdFunctions::kStatusSize] = {};
  const bool answers = sdk_->dhdGetStatus(status, *id) >= 0;
  const bool knows_zero = status[DhdFunctions::kStatusReset] != 0;
  if (answers) has_lost_zero_.store(!knows_zero);
  // A force that the user or a guard switched off, before the loss or since, stays off.
  const bool stays_off = is_for_people(force_off_cause_.load()) ||
                         (status[DhdFunctions::kStatusForce] == 0 &&
                          is_for_people(status[DhdFunctions::kStatusForceOffCause]));
  if (!answers || !knows_zero || !set_zero_force(*sdk_, *id) ||
      (!stays_off && sdk_->dhdEnableForce(1, *id) < 0)) {
    sdk_->dhdClose(*id);
    return false;
  }
  id_ = *id;
  is_robotic_ = false;
  return true;
}

// Whether a call to the SDK succeeded. Stores the error of the first one that did not.
bool ForceDimensionDevice::take(int answer, const char* function) noexcept {
  if (answer >= 0) return true;
  if (!has_failed_.load(std::memory_order_relaxed)) {
    const char* words = sdk_->dhdErrorGetLastStr();
    std::size_t length = 0;
    const auto append = [&](const char* text) {
      while (*text != '\0' && length + 1 < failure_.size()) failure_[length++] = *text++;
    };
    append(function);
    append(": ");
    append(words == nullptr ? "no reason reported" : words);
    has_failed_.store(true, std::memory_order_release);
  }
  answers_.store(false, std::memory_order_relaxed);
  return false;
}

// At every reading: after the hand left the handle for a moment, or a button was pressed twice, the previous force must
// not return.
void ForceDimensionDevice::look_at_status() noexcept {
  int status[DhdFunctions::kStatusSize] = {};
  if (sdk_->dhdGetStatus(status, id_) < 0)
    return;  // a device that does not answer is found by its position
  force_is_on_ = status[DhdFunctions::kStatusForce] != 0;
  force_off_cause_.store(force_is_on_ ? -1 : status[DhdFunctions::kStatusForceOffCause],
                         std::memory_order_relaxed);
}

// A device for the left hand counts the angle in the opposite direction.
void ForceDimensionDevice::look_at_gripper(ProbeState& state) noexcept {
  double angle_rad = 0.0;
  if (sdk_->dhdGetGripperAngleRad(&angle_rad, id_) >= 0) {
    if (std::abs(angle_rad) < kGripped_rad) is_gripped_ = true;
    if (std::abs(angle_rad) > kLetGo_rad) is_gripped_ = false;
  }
  state.buttons = (state.buttons & ~kGripperButton) | (is_gripped_ ? kGripperButton : 0);
}

// Gives the device up when this has gone on for too long.
void ForceDimensionDevice::fail_at(std::int64_t now_ns) noexcept {
  if (!failing_since_ns_) failing_since_ns_ = now_ns;
  if (now_ns - *failing_since_ns_ <= kLongestFailure_ns) return;
  failing_since_ns_.reset();
  has_read_ = false;
  velocity_.reset();
  angular_velocity_.reset();
  is_given_up_.store(true, std::memory_order_release);
}

bool ForceDimensionDevice::do_read(std::int64_t now_ns, ProbeState& state) noexcept {
  if (is_given_up_.load(std::memory_order_acquire)) return false;
  glm::dvec3 theirs_m{0.0};
  double rows[3][3] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
  const int answer = has_wrist_ ? sdk_->dhdGetPositionAndOrientationFrame(&theirs_m.x, &theirs_m.y,
                                                                          &theirs_m.z, rows, id_)
                                : sdk_->dhdGetPosition(&theirs_m.x, &theirs_m.y, &theirs_m.z, id_);
  if (!take(answer, has_wrist_ ? "dhdGetPositionAndOrientationFrame" : "dhdGetPosition")) {
    fail_at(now_ns);
    return false;
  }
  failing_since_ns_.reset();
  answers_.store(true, std::memory_order_relaxed);
  look_at_status();

  if (answer == DhdFunctions::kTimeGuard && has_read_) {
    read_again();
    state = last_;
    state.time_ns = now_ns;
    const bool is_stale = now_ns - last_new_ns_ > kLongestStale_ns;
    is_stale_.store(is_stale, std::memory_order_relaxed);
    return !is_stale;
  }
  has_read_ = true;
  last_new_ns_ = now_ns;
  is_stale_.store(false, std::memory_order_relaxed);

  state.position_m = ours_from(theirs_m);
  state.velocity_m_per_s = velocity_.add(now_ns, state.position_m);
  if (has_wrist_) {
    state.orientation = orientation_from(rows);
    turned_rad_ += small_turn_rad(last_.orientation, state.orientation);
    state.angular_velocity_rad_per_s = angular_velocity_.add(now_ns, turned_rad_);
  }
  state.buttons = sdk_->dhdGetButtonMask(id_);
  if (has_gripper_) look_at_gripper(state);
  last_ = state;
  return true;
}

bool ForceDimensionDevice::do_send(const Wrench& limited) noexcept {
  if (is_given_up_.load(std::memory_order_acquire)) return false;
  // A force that is sent while the force is off would be exerted as soon as it is switched on.
  const Wrench sent = force_is_on_ ? limited : Wrench{};
  const glm::dvec3 force_N = theirs_from(sent.force_N);
  const glm::dvec3 torque_N_m = theirs_from(sent.torque_N_m);
  const int answer = sdk_->dhdSetForceAndTorqueAndGripperForce(
      force_N.x, force_N.y, force_N.z, torque_N_m.x, torque_N_m.y, torque_N_m.z, 0.0, id_);
  if (answer == DhdFunctions::kMotorSaturated) {
    gave_less();
    saturated_.fetch_add(1, std::memory_order_relaxed);
    pushes_since_saturated_ = 0;
  } else if (pushes_since_saturated_ < kPushesToForget) {
    ++pushes_since_saturated_;
  } else {
    saturated_.store(0, std::memory_order_relaxed);
  }
  return take(answer, "dhdSetForceAndTorqueAndGripperForce") && force_is_on_;
}

void ForceDimensionDevice::zero_force_from_outside() noexcept {
  // While the keeper has it, the device is being closed or opened again, at zero.
  const std::unique_lock alone(mutex_, std::try_to_lock);
  if (alone.owns_lock() && !is_closed_) set_zero_force(*sdk_, id_);
}

std::string ForceDimensionDevice::trouble() const {
  const std::string who = capability().model + " " + capability().serial;
  std::string sentences;
  const auto tell = [&sentences](const std::string& sentence) {
    sentences += (sentences.empty() ? "" : " ") + sentence;
  };
  if (has_lost_zero_.load()) {
    tell(who +
         " is connected again and has lost its zero: end the session, and run \"asperity "
         "device-test\", which "
         "requests confirmation and then finds the zero.");
  } else if (!answers_.load()) {
    const bool has_words = has_failed_.load(std::memory_order_acquire);
    tell(who + " does not respond" + (has_words ? " (" + std::string(failure_.data()) + ")" : "") +
         ". Check its power and its cable.");
  } else if (is_stale_.load()) {
    tell(who + " has sent nothing new for 50 ms. Check its cable.");
  }
  const int cause = force_off_cause_.load();
  if (cause >= 0) tell("The force of " + who + " is off: " + cause_of(cause) + ".");
  const std::uint64_t saturated = saturated_.load();
  if (saturated > 0) {
    tell("The motors of " + who + " exerted less force than requested on " +
         std::to_string(saturated) + (saturated == 1 ? " occasion" : " occasions") +
         ". If this recurs, lower the forces that the protocol requests.");
  }
  return sentences;
}

}  // namespace asperity
