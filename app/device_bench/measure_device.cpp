// Locks out sessions and other measurements, tests the device, and writes the profile into the study.

#include "app/device_bench/measure_device.h"

#include "analysis/numbers/number_text.h"
#include "app/profiles/device_kind.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/study_sharing.h"

namespace asperity {
namespace {

constexpr const char* kLock = "device-test";

}  // namespace

MeasuringLock::MeasuringLock(const std::filesystem::path& study) {
  (void)Study::open(study, Access::read_only);  // nothing is written into what is none
  lock_.emplace(study, kLock);
  // Their locks, and not the sessions that are stored: one is stored only when its device is open.
  const std::string of_session = Study::session_lock_name({});
  const std::vector<std::string> held = StudyLock::held(study, of_session);
  if (held.empty()) return;
  throw PhrasedError(
      phrase("DeviceTest",
             "A session of %1 is running. Measure the device when the session has ended.")
          .with(held.front().substr(of_session.size())));
}

void require_nothing_measured(const std::filesystem::path& study) {
  if (!StudyLock::holder(study, kLock)) return;
  throw PhrasedError(phrase("DeviceTest",
                            "A device is being measured for this study. Stop the measurement or "
                            "wait until it has ended, then start the session."));
}

MeasuredDevice measure_device(HapticDevice& device, const MeasureOrder& order,
                              const std::stop_token& stop) {
  DeviceTestOptions test = order.test;
  test.is_simulated = kind_of_device(device.capability().name) == DeviceKind::simulated;
  if (test.is_simulated) {
    // Nobody feels it, and its mechanics know only the times that it is read at.
    test.mechanics = StagePacing::stepped;
  } else {
    test.workspace_s = order.borders_s;
  }
  for (const auto& [name, limit] : order.protocol_limits) {
    const DeviceQuantity* const quantity = device_quantity(name);
    if (test.is_simulated && quantity != nullptr && quantity->is_timing) continue;
    test.limits.emplace(name, limit);
  }
  MeasuredDevice measured{.profile = test_device(device, test, stop)};
  if (stop.stop_requested())
    throw DeviceStageStopped(
        "the test of the device was stopped on request, and the force is zero; to measure the "
        "device, begin the test again");
  if (order.study) {
    const std::filesystem::path file = profile_path(*order.study, measured.profile);
    make_folders(file.parent_path());
    write_file(file, json_text_of(measured.profile), Overwrite::refuse);
    measured.file = file;
  }
  return measured;
}

Phrase what_measuring_does(const std::string& device, double force_N) {
  return phrase("DeviceTest",
                "the handle of %1 will move by itself for one and a half to three minutes, by at "
                "most 3 cm, "
                "with a force of at most %2 N. Let it hang free in the middle of its workspace, "
                "keep hands and hair away, and make sure that it is not held.")
      .with(device, fixed(force_N, 1));
}

VirtualHand hand_to_measure() { return {HandHabits{}, Random(0)}; }

}  // namespace asperity
