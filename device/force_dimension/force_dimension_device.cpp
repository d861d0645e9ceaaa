// A delta, omega, sigma or lambda of Force Dimension, through its maker's SDK.

#include "device/force_dimension/force_dimension_device.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>

#include "device/small_turn.h"
#include "device/units_in_use.h"

namespace asperity {
namespace {

constexpr std::int64_t kLongestStale_ns = 50'000'000;
constexpr std::int64_t kLongestFailure_ns = 200'000'000;
constexpr std::chrono::milliseconds kBetweenTrials(250);
// How many pushes in full it takes before motors that were saturated are no news any more: two seconds' worth.
constexpr int kPushesToForget = 2000;
constexpr const char* kForceDimension = "force_dimension";
constexpr double kGripped_rad = 10.0 * std::numbers::pi / 180.0;
constexpr double kLetGo_rad = 15.0 * std::numbers::pi / 180.0;
constexpr std::uint32_t kGripperButton = 2;  // the bit

// The SDK's x is towards the participant and its y to their right; ours are their right and away from them.
glm::dvec3 ours_from(const glm::dvec3& theirs) noexcept { return {theirs.y, -theirs.x, theirs.z}; }
glm::dvec3 theirs_from(const glm::dvec3& ours) noexcept { return {-ours.y, ours.x, ours.z}; }

// The same turn, told in our axes: C·R·Cᵀ, where the rows of C are our axes in theirs.
glm::dquat orientation_from(const double (&rows)[3][3]) noexcept {
  const auto column = [&rows](int j) { return ours_from({rows[0][j], rows[1][j], rows[2][j]}); };
  return glm::quat_cast(glm::dmat3(column(1), -column(0), column(2)));
}

std::string place_of(int index) { return "dhd " + std::to_string(index); }

// Of the SDK: what switched the force off.
constexpr int kByButton = 1;
constexpr int kByVelocityGuard = 2;
constexpr int kByDeadman = 6;

// A person, or the guard over what a person did, switched the force off: it is theirs to switch on again.
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

std::string last_error_of(const DhdFunctions& sdk) {
  const char* words = sdk.dhdErrorGetLastStr();
  return words == nullptr ? "the SDK states no reason" : words;
}

// What the SDK says of the device with this index while it is open; its own number for it.
struct Identity {
  char index = 0;
  char id = 0;
  int type = -1;
  std::string serial{};
  bool is_robotic = false;  ///< opened by libdrd as well
};

void close_device(const DhdFunctions& sdk, const Identity& identity) {
  identity.is_robotic ? sdk.drdClose(identity.id) : sdk.dhdClose(identity.id);
}

}  // namespace

struct ForceDimensionDevice::Opened {
  Identity identity{};
  DhdModel model{};
};

namespace {

Identity identity_of(const DhdFunctions& sdk, int index, int id) {
  Identity identity{.index = static_cast<char>(index),
                    .id = static_cast<char>(id),
                    .type = sdk.dhdGetSystemType(static_cast<char>(id))};
  unsigned short serial = 0;
  if (sdk.dhdGetSerialNumber(&serial, identity.id) >= 0) identity.serial = std::to_string(serial);
  return identity;
}

Identity open_index(const DhdFunctions& sdk, int index) {
  const int id = sdk.dhdOpenID(static_cast<char>(index));
  if (id < 0) {
    throw std::runtime_error("The Force Dimension device at " + place_of(index) +
                             " cannot be opened: " + last_error_of(sdk) +
                             ". Check that no other program uses it and that this user may open it "
                             "(udev rule for USB vendor 1451).");
  }
  return identity_of(sdk, index, id);
}

std::string unknown_type(int type) {
  return "This device of Force Dimension is of the system type " + std::to_string(type) +
         ", which is unknown to this program: its force limits are unknown, too. Use a device of a "
         "known type.";
}

// What its controller says, which is also what its lamp shows.
bool knows_its_zero(const DhdFunctions& sdk, const Identity& identity) {
  int status[DhdFunctions::kStatusSize] = {};
  return sdk.dhdGetStatus(status, identity.id) >= 0 && status[DhdFunctions::kStatusReset] != 0;
}

// What was asked of it before it was let go of, it would give again when somebody switches its force on.
bool is_at_zero(const DhdFunctions& sdk, char id) noexcept {
  return sdk.dhdSetForceAndTorqueAndGripperForce(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, id) >= 0;
}

// That something is over, for threads that wait for it.
class Ending final {
 public:
  void come() {
    {
      const std::lock_guard lock(mutex_);
      has_come_ = true;
    }
    changed_.notify_all();
  }
  /// Whether it had come before the stop.
  bool wait(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    return changed_.wait(lock, stop, [this] { return has_come_; });
  }
  /// Whether it came in that time.
  bool wait_for(std::chrono::milliseconds longest) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, longest, [this] { return has_come_; });
  }

 private:
  std::mutex mutex_{};
  std::condition_variable_any changed_{};
  bool has_come_ = false;
};

// While it lives, a stop ends the movement for which another thread waits in drdAutoInit.
//
// That function hears of no stop. Its regulation is a thread of the SDK's, which every other call reaches while it
// runs. What nobody outside knows is whether it switches the force on once more before it gives up, and whether each of
// the two calls returns meanwhile: so both are made again and again until it has given up, each from a thread of its
// own, and neither waits for the other.
class MovementEnder final {
 public:
  MovementEnder(const DhdFunctions& sdk, char id, const std::stop_token& stop)
      : takes_force_([this, &sdk, id, stop] { repeat(stop, [&sdk, id] { sdk.dhdStop(id); }); }),
        ends_regulation_(
            [this, &sdk, id, stop] { repeat(stop, [&sdk, id] { sdk.drdStop(false, id); }); }) {}
  ~MovementEnder() { ending_.come(); }
  MovementEnder(const MovementEnder&) = delete;
  MovementEnder& operator=(const MovementEnder&) = delete;

 private:
  static constexpr std::chrono::milliseconds kBetweenStops{10};

  template <typename Call>
  void repeat(const std::stop_token& stop, const Call& call) {
    if (ending_.wait(stop)) return;
    do call();
    while (!ending_.wait_for(kBetweenStops));
  }

  Ending ending_{};
  std::jthread takes_force_;
  std::jthread ends_regulation_;
};

// Tells, once, where it still lives a second after a stop. It calls nothing of the SDK's: that its functions do not
// return is what may have to be told.
class OverdueStop final {
 public:
  OverdueStop(const std::stop_token& stop, std::function<void()> tell)
      : thread_([this, stop, tell = std::move(tell)] {
          if (!ending_.wait(stop) && !ending_.wait_for(kToGiveUp)) tell();
        }) {}
  ~OverdueStop() { ending_.come(); }
  OverdueStop(const OverdueStop&) = delete;
  OverdueStop& operator=(const OverdueStop&) = delete;

 private:
  static constexpr std::chrono::seconds kToGiveUp{1};

  Ending ending_{};
  std::jthread thread_;
};

// Refuses a device whose regulation may go on.
void require_let_go(const DhdFunctions& sdk, char id, const std::string& who, bool is_stopped) {
  // true: force stays ours to send. While the SDK's own regulation runs, it is not.
  if (sdk.drdStop(!is_stopped, id) >= 0) return;
  const std::string words = last_error_of(sdk);
  // What the ender has switched off already may be nothing to switch off.
  if (sdk.drdIsRunning != nullptr && !sdk.drdIsRunning(id)) return;
  if (is_stopped && sdk.drdIsRunning == nullptr) {
    throw std::runtime_error(
        who +
        " was stopped on request while it moved to find its zero, and the SDK did not confirm that "
        "it stopped (" +
        words + "). Watch the handle from a distance; if it moves, switch the device off.");
  }
  throw std::runtime_error("The SDK does not release " + who + " (" + words +
                           ") and may still move it: switch the device off.");
}

// Has the device find its zero where it has lost it: it moves, and nobody may be hit who was not told.
void find_zero(const DhdFunctions& sdk, Identity& identity, const std::string& model,
               const ForceDimensionDevice::MayMove& may_move, const std::stop_token& stop,
               const ForceDimensionDevice::Tell& tell) {
  if (knows_its_zero(sdk, identity)) return;
  const std::string who = model + " " + identity.serial;
  if (!sdk.has_robotics()) {
    throw std::runtime_error(
        who +
        " is not calibrated, and libdhd alone cannot calibrate it: install libdrd of the same SDK, "
        "or calibrate the device with its manufacturer's program.");
  }
  if (!may_move) {
    throw std::runtime_error(who +
                             " has lost its zero, as happens when it is switched off, and has to "
                             "move by itself to find it. It was not moved, because the user cannot "
                             "be asked here. First run \"asperity device-test force_dimension" +
                             (identity.serial.empty() ? "" : ":" + identity.serial) +
                             sdk.library_option() +
                             "\", which requests confirmation before the device moves, or "
                             "calibrate the device as its manufacturer's manual describes.");
  }
  const auto require_no_stop = [&] {
    if (!stop.stop_requested()) return;
    throw OpeningStopped(who + " was closed and not moved: opening it was stopped on request");
  };
  // Others may look for devices while somebody thinks.
  const UnitInUse asked_about(
      kForceDimension,
      {.model = model, .serial = identity.serial, .place = place_of(identity.index)});
  const bool is_agreed =
      may_move("the handle of " + who +
               " will move by itself, through its workspace and for some seconds, to find its "
               "zero.\n  Let it hang free, keep hands and hair away, and make sure that it is not "
               "held. If something is in its way, switch the device off.");
  require_no_stop();
  if (!is_agreed) {
    throw std::runtime_error(
        who +
        " has lost its zero and was not moved, because the movement was not confirmed. Open it "
        "again and confirm, or calibrate it with its manufacturer's program.");
  }
  // By its index: the SDK's pages hand out the ID of a device that is open already.
  const int id = sdk.drdOpenID(identity.index);
  identity.is_robotic = id == identity.id;
  if (!identity.is_robotic) {
    if (id >= 0) sdk.drdClose(static_cast<char>(id));
    throw std::runtime_error("libdrd cannot open " + who + ": " + last_error_of(sdk) +
                             ". It was not moved; check that no other program uses it.");
  }
  require_no_stop();
  bool found = false;
  bool is_stopped = false;
  std::string words;
  {
    const OverdueStop overdue(stop, [&who, &tell] {
      if (!tell) return;
      tell("The SDK still moves " + who +
           " after a request to stop: switch the device off, and keep away from its handle.");
    });
    {
      const MovementEnder ender(sdk, identity.id, stop);
      found = sdk.drdAutoInit(identity.id) >= 0;
      if (!found) words = last_error_of(sdk);  // of this thread's last call
    }
    is_stopped = stop.stop_requested();
    if (is_stopped) sdk.dhdStop(identity.id);
    require_let_go(sdk, identity.id, who, is_stopped);
  }
  if (is_stopped) {
    throw OpeningStopped(
        who +
        " was stopped on request while it moved to find its zero: its force is off, and its handle "
        "sinks slowly. Open it again to repeat the movement; confirmation is requested first.");
  }
  if (!found) {
    throw std::runtime_error(
        who + " did not find its zero: " + words +
        ". Clear its workspace, release the handle and open the device again.");
  }
}

}  // namespace

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
          if (!is_at_zero(*sdk, opened.identity.id) ||
              sdk->dhdEnableForce(1, opened.identity.id) < 0) {
            throw std::runtime_error(opened.model.capability.model + " " + opened.identity.serial +
                                     " cannot switch its force on: " + last_error_of(*sdk) +
                                     ". Check that it has power.");
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
      in_use_(kForceDimension, {.model = capability().model,
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
    // Somebody looks for devices, or opens one: there is a next time.
    const std::unique_lock alone(UnitInUse::looking(), std::try_to_lock);
    if (!alone.owns_lock() || !reopen()) continue;
    is_closed_ = false;
    is_given_up_.store(false, std::memory_order_release);
  }
}

// The ID of the device with our serial number, opened, at whatever place it is now.
std::optional<char> ForceDimensionDevice::find_again() {
  const std::string& serial = capability().serial;
  if (sdk_->dhdOpenSerial != nullptr && !serial.empty()) {
    const int id = sdk_->dhdOpenSerial(std::stoi(serial));
    if (id >= 0) return static_cast<char>(id);
  }
  // A model or an SDK that cannot be asked by serial number: each has to be opened to tell its own, which nobody
  // else may be using.
  const int count = sdk_->dhdGetDeviceCount();
  const bool all_are_free = sdk_->dhdGetAvailableCount != nullptr &&
                            sdk_->dhdGetAvailableCount() >= count &&
                            UnitInUse::of(kForceDimension).size() == 1;
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
  // What people or their guard had switched off when it was lost, or have switched off since, stays off.
  const bool stays_off = is_for_people(force_off_cause_.load()) ||
                         (status[DhdFunctions::kStatusForce] == 0 &&
                          is_for_people(status[DhdFunctions::kStatusForceOffCause]));
  if (!answers || !knows_zero || !is_at_zero(*sdk_, *id) ||
      (!stays_off && sdk_->dhdEnableForce(1, *id) < 0)) {
    sdk_->dhdClose(*id);
    return false;
  }
  id_ = *id;
  is_robotic_ = false;
  return true;
}

// Whether the SDK did what it was asked; keeps its words for the first time that it did not.
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

// At every reading: a hand that is off the handle for a moment, or a button that is pressed twice, must not find the
// force of before.
void ForceDimensionDevice::look_at_status() noexcept {
  int status[DhdFunctions::kStatusSize] = {};
  if (sdk_->dhdGetStatus(status, id_) < 0) return;  // whether it answers, its position tells
  force_is_on_ = status[DhdFunctions::kStatusForce] != 0;
  force_off_cause_.store(force_is_on_ ? -1 : status[DhdFunctions::kStatusForceOffCause],
                         std::memory_order_relaxed);
}

// Of a device for the left hand the angle counts the other way.
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
  // What it holds while its force is off, it gives when somebody switches it on.
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

std::string ForceDimensionDevice::trouble() const {
  const std::string who = capability().model + " " + capability().serial;
  std::string told;
  const auto tell = [&told](const std::string& sentence) {
    told += (told.empty() ? "" : " ") + sentence;
  };
  if (has_lost_zero_.load()) {
    tell(who +
         " is back and has lost its zero: end the session, and run \"asperity device-test\", which "
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
    tell("The motors of " + who + " exerted less force than requested " +
         std::to_string(saturated) + (saturated == 1 ? " time." : " times."));
  }
  return told;
}

namespace {

DriverSurvey survey_of(const DhdFunctions& sdk, const std::stop_token& stop) {
  DriverSurvey survey{.found = sdk.description(), .attached = UnitInUse::of(kForceDimension)};
  const std::vector<AttachedDevice> ours = survey.attached;
  const int count = std::max(0, sdk.dhdGetDeviceCount());
  // The SDK hands an open device out again without a word, and closing it would end it under whoever uses it.
  // Which index is whose can change with what is plugged in: while one is used, none is opened.
  const bool one_is_used =
      !ours.empty() || (sdk.dhdGetAvailableCount != nullptr && sdk.dhdGetAvailableCount() < count);
  for (int index = 0; index < count && !stop.stop_requested(); ++index) {
    AttachedDevice device{.model = "Force Dimension", .place = place_of(index)};
    if (std::any_of(ours.begin(), ours.end(),
                    [&device](const AttachedDevice& used) { return used.place == device.place; })) {
      continue;
    }
    if (one_is_used) {
      device.hindrance =
          "A device of Force Dimension is in use; its model can be read when it is free.";
      survey.attached.push_back(device);
      continue;
    }
    try {
      const Identity identity = open_index(sdk, index);
      device.serial = identity.serial;
      if (const std::optional<DhdModel> model = dhd_model_of(identity.type)) {
        device.model = model->capability.model;
        device.remark =
            sdk.has_robotics()
                ? "After it was switched off it has to move by itself, for some seconds, to find "
                  "its zero; confirmation is requested before it moves."
                : "";
      } else {
        device.hindrance = unknown_type(identity.type);
      }
      sdk.dhdClose(identity.id);
    } catch (const std::runtime_error& refusal) {
      device.hindrance = refusal.what();
    }
    survey.attached.push_back(device);
  }
  return survey;
}

// Asks while others may look for devices. A yes is one to a movement now: who waited may have put a hand there again.
bool agrees_now(const DriverOptions& options, const std::string& sentence) {
  constexpr std::chrono::seconds kLongestAfterYes(1);
  bool is_agreed = false;
  std::chrono::steady_clock::time_point answered{};
  {
    const LetOthersLook meanwhile(options.alone, options.stop);
    is_agreed = options.may_move(sentence);
    answered = std::chrono::steady_clock::now();
  }
  const auto waited = std::chrono::steady_clock::now() - answered;
  if (is_agreed && !options.stop.stop_requested() && waited > kLongestAfterYes) {
    throw std::runtime_error(
        "The device was not moved: another search for devices delayed it by more than a second "
        "after the confirmation. Open it again, and confirm again.");
  }
  return is_agreed;
}

}  // namespace

Driver force_dimension_driver() {
  return {.id = "force_dimension",
          .name = "Force Dimension",
          .summary =
              "delta, omega, sigma and lambda of Force Dimension, through the manufacturer's SDK.",
          .velocity = ForceDimensionDevice::kWindow,
          .find =
              [](const DriverOptions& options) {
                try {
                  const DhdFunctions sdk(options.library);
                  return survey_of(sdk, options.stop);
                } catch (const std::runtime_error& refusal) {
                  return DriverSurvey{.hindrance = refusal.what()};
                }
              },
          .open = [](const std::string& which,
                     const DriverOptions& options) -> std::unique_ptr<HapticDevice> {
            auto sdk = std::make_shared<const DhdFunctions>(options.library);
            const std::vector<AttachedDevice> attached = survey_of(*sdk, options.stop).attached;
            if (options.stop.stop_requested()) {
              throw OpeningStopped(
                  "no device of Force Dimension was opened: opening was stopped on request");
            }
            ForceDimensionDevice::MayMove may_move{};
            if (options.may_move) {
              may_move = [&options](const std::string& sentence) {
                return agrees_now(options, sentence);
              };
            }
            const std::string place =
                choose_attached("device of Force Dimension", attached, which).place;
            for (std::size_t index = 0; index < attached.size(); ++index) {
              if (attached[index].place != place) continue;
              return std::make_unique<ForceDimensionDevice>(std::move(sdk), static_cast<int>(index),
                                                            may_move, options.stop, options.tell);
            }
            throw std::logic_error(
                "the chosen device is not attached; plug it in, or choose another device");
          }};
}

}  // namespace asperity
