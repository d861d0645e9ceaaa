// Measurement of a device on request, at a terminal or in a window, with its profile kept.

#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <stop_token>
#include <string>

#include "analysis/words/phrase.h"
#include "app/device_bench/device_test.h"
#include "app/profiles/device_profile.h"
#include "app/words/phrase_of_error.h"
#include "device/haptic_device.h"
#include "device/virtual_hand.h"
#include "results_schema/study.h"

namespace asperity {

struct MeasureOrder {
  /// Rate, force, limits, receivers of progress; what depends on the device is filled in.
  DeviceTestOptions test{};
  /// What a protocol holds the device to, where `test.limits` says nothing else.
  std::map<std::string, double> protocol_limits{};
  /// How long a person moves the handle of a real device along its borders; 0: it is not moved.
  double borders_s = 0.0;
  std::optional<std::filesystem::path> study{};  ///< keeps the profile
};

struct MeasuredDevice {
  DeviceProfile profile{};
  std::optional<std::filesystem::path> file{};  ///< that the study has it in
};

/// While it lives a device is measured for this study: sessions in real time do not begin, in whichever process.
///
/// Errors: PhrasedError where a session of the study runs or is about to; ResultsError where a device is measured for
/// it already, and where the folder is no study.
class MeasuringLock final {
 public:
  explicit MeasuringLock(const std::filesystem::path& study);

 private:
  std::optional<StudyLock> lock_{};
};
/// For a session that holds its own lock already, so that of both one sees the other.
/// Errors: PhrasedError where a device is measured for this study now.
void require_nothing_measured(const std::filesystem::path& study);

/// Measures an open device: see `test_device`. Of a simulated one, which no participant feels, the mechanics are
/// stepped, and a protocol's limits on timing are left out: timing is reported and not judged. Before a
/// real one moves, a person next to it has been informed and has agreed; from before it is opened there is
/// a MeasuringLock of `order.study`.
///
/// Errors: as `test_device` (DriverHangs: release the device), DeviceStageStopped also where the stop comes after the last force: nothing is
/// kept then. ResultsError where the profile cannot be written.
MeasuredDevice measure_device(HapticDevice& device, const MeasureOrder& order,
                              const std::stop_token& stop);

/// What a person has to know before: how a handle will move, how far, how hard, and what to do about it.
/// `device` is its model and serial number. In the middle of a sentence.
Phrase what_measuring_does(const std::string& device, double force_N);

/// The hand that holds the probe of a simulated device that is measured: always the same.
VirtualHand hand_to_measure();

/// Time for moving the handle once around.
inline constexpr double kBorders_s = 20.0;

}  // namespace asperity
