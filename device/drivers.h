// The drivers of this program: what each finds attached, and how one of the found is opened.

#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "device/haptic_device.h"
#include "device/latest_value.h"
#include "device/pointer_sample.h"
#include "device/simulated_device.h"
#include "device/velocity_estimator.h"

namespace asperity {

/// Opening a device was stopped on request. The device was closed.
class OpeningStopped final : public std::runtime_error {
  using std::runtime_error::runtime_error;
};
/// The search for devices was stopped on request. What was found by then is not reported.
class LookStopped final : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The laboratory's settings of the drivers. Each driver takes what concerns it and ignores the rest.
struct DriverOptions {
  /// File with the firmware of a device that forgets it when it is switched off (falcon).
  std::filesystem::path firmware{};
  /// The maker's library, where it is not one that the system finds by itself.
  std::filesystem::path library{};
  /// Where the maker's local service listens, "HOST:PORT", where not at its usual place.
  std::string service{};
  /// Called, while a device is opened, with what the user has to do for it ("pull the grip out…").
  std::function<void(const std::string& sentence)> tell{};
  /// Called before a device that is opened moves by itself, with a sentence on what it will do: true when a user who
  /// can see the device has read the sentence and agrees. Null: no user can be asked, and a device that has to move
  /// first is refused.
  std::function<bool(const std::string& sentence)> may_move{};
  /// Asks an opening to end, with OpeningStopped, or a look, with LookStopped: at once where a driver waits for a
  /// person, for firmware or for a service, and where a device moves by itself, whose force is off then; otherwise
  /// when the maker's function that is under way returns.
  std::stop_token stop{};
  /// Filled in by DriverRegistry: its lock, which a driver releases while it waits for the user (LetOthersLook).
  std::unique_lock<std::mutex>* alone = nullptr;
  /// Drivers with a thread of their own ask for SCHED_FIFO; refused, they go on without.
  bool wants_fifo = true;
  /// This program, which the command close-device makes open and close a device (ClosingProcess). Empty: where the program is
  /// killed, such a device is left unchanged, and it is opened and searched for without a DeviceClaim.
  std::filesystem::path closing_program{};
  /// What holds the probe of the simulated device; has to outlive it. Null elsewhere.
  VirtualHand* hand = nullptr;
  SimulatedDeviceSettings simulated{};
  /// Reads the hand of a recording, for the device "replay". Errors: std::exception with a sentence.
  std::function<std::vector<ProbeState>(const std::filesystem::path& file)> recorded_hand{};
  /// What a window feeds the device "mouse" through; has to outlive it. Null where there is no window.
  LatestValue<PointerSample>* pointer = nullptr;
};

/// One device that a driver sees.
struct AttachedDevice {
  std::string model{};
  std::string serial{};  ///< empty where the device reports none
  std::string place{};   ///< where it is attached, "usb 1-2.3"; distinguishes two of a kind
  std::string remark{};  ///< a sentence about a usable one for the user, or empty
  /// Empty for a device that can be opened now; otherwise a sentence: what stands in the way, and what
  /// would make it usable (a permission, firmware, another program that holds it).
  std::string blocker{};

  bool is_usable() const noexcept { return blocker.empty(); }
};

/// What a driver found when it looked.
struct DriverSurvey {
  std::string found{};    ///< what it needs and has: "libdhd 3.17.5 in /usr/lib/…"; or empty
  std::string blocker{};  ///< a sentence for a driver that cannot work at all; or empty
  std::vector<AttachedDevice> attached{};
};

/// A driver: a kind of device, found and opened.
///
/// Threads: `find` and `open` from any thread, one call at a time, which DriverRegistry sees to; both may take
/// seconds. `find` leaves a device that a session uses alone.
struct Driver {
  std::string id{};       ///< `[a-z][a-z0-9_]*`, the name in `--device` and in DeviceCapability
  std::string name{};     ///< as people call its devices, "Novint Falcon"; empty: as the id
  std::string summary{};  ///< one sentence
  /// False for one whose devices only measure where the hand is: they are measured without the user's consent.
  bool has_motors = true;
  /// Where a program that drives its devices is killed, they are opened and closed by another process (ClosingProcess): the
  /// driver has no process that sends zero by itself.
  bool is_closed_by_another_process = false;
  /// How it estimates velocity from positions; nothing where its devices give a velocity of their own.
  std::optional<VelocityWindow> velocity{};
  /// The position step that all of its devices have, as they declare it; nothing where it is unknown or depends on the model.
  std::optional<double> position_step_m{};
  /// Never throws for what the machine lacks: that is a blocker.
  std::function<DriverSurvey(const DriverOptions&)> find{};
  /// Opens the one whose serial or place is `which`; the only one attached when that is empty.
  /// Errors: std::runtime_error with a sentence: what is wrong, and what would be right; OpeningStopped.
  std::function<std::unique_ptr<HapticDevice>(const std::string& which, const DriverOptions&)>
      open{};
};

/// The drivers of a program.
///
/// Threads: any. `survey` and `open` wait for each other, whichever registry they are called on: what a driver
/// looks into (a maker's library, a bus) is one for the process (UnitInUse::looking). While a driver waits for a
/// person, others look and open: what it has open then is in use.
///
/// Errors: `add` throws std::invalid_argument for an id that is taken or not `[a-z][a-z0-9_]*`.
class DriverRegistry final {
 public:
  void add(Driver driver);
  const std::vector<Driver>& drivers() const& noexcept { return drivers_; }
  const std::vector<Driver>& drivers() && = delete;  // a loop over a temporary's would dangle
  /// Null when there is no driver of this name.
  const Driver* find(std::string_view id) const& noexcept;
  const Driver* find(std::string_view id) && = delete;

  /// What one of its drivers finds.
  /// Where another process drives a device of the driver (DeviceClaim), that is its blocker, and the driver does not look.
  /// Errors: LookStopped, also where the stop comes while another thread looks or opens.
  DriverSurvey survey(const Driver& driver, const DriverOptions& options) const;
  /// Opens what `--device` names: ID, or ID:SERIAL, or ID:PLACE.
  /// Where another process drives a device of the driver (DeviceClaim), it waits up to 5 s before it opens anything.
  /// Errors: std::runtime_error, for an unknown driver with the names of all; as Driver::open does; OpeningStopped
  /// also where the stop comes while another thread looks or opens, or before the driver is done.
  std::unique_ptr<HapticDevice> open(const std::string& name, const DriverOptions& options) const;

 private:
  std::vector<Driver> drivers_{};
};

/// Every driver that this program was built with, the simulated device first.
DriverRegistry built_in_drivers();

/// How the velocity of a device is estimated, by driver and model as a DeviceCapability names them; nothing where it is
/// not estimated here, or the driver is unknown.
std::optional<VelocityWindow> velocity_window_of(std::string_view driver, std::string_view model);

/// For drivers: the attached device whose serial or place is `which`, or the only one.
///
/// Errors: std::runtime_error when there is none, when several fit (naming each), and with the
/// blocker of one that cannot be used. `product` is what people call it, e.g. "Novint Falcon".
AttachedDevice choose_attached(const std::string& product,
                               const std::vector<AttachedDevice>& attached,
                               const std::string& which);

}  // namespace asperity
