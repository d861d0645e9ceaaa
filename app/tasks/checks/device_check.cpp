// Opens the device, and compares it with the requirements and with the device of the session so far.

#include "app/tasks/checks/device_check.h"

#include <optional>
#include <string>
#include <vector>

#include "analysis/numbers/number_text.h"
#include "app/device_bench/device_choice.h"
#include "app/records/session_conditions.h"
#include "app/session/rig/rig.h"
#include "app/session/session_setup.h"
#include "app/tasks/checks/device_requirements.h"
#include "app/tasks/session_run.h"
#include "app/tasks/unfinished_session.h"
#include "device/pointer_device.h"

namespace asperity {
namespace {

using State = SessionCheck::State;

std::optional<SessionRow> resumed_row(const CheckInputs& inputs, const Protocol& protocol) {
  if (!inputs.resume) return {};
  return unfinished_row(Study::open(inputs.study, Access::read_only), protocol, inputs.participant,
                        inputs.resumed_session);
}

/// The device that an unfinished session last ran on if it differs from this one; otherwise empty.
std::string other_device_before(const CheckInputs& inputs,
                                const std::optional<SessionRow>& unfinished,
                                const DeviceCapability& device) {
  if (!unfinished) return {};
  const RecordedDevice before =
      last_recorded_device(Study::open(inputs.study, Access::read_only), *unfinished);
  return before.is_same_as(recorded_device(device)) ? std::string() : before.full_text();
}

/// The name of the device in the list from which it was chosen.
std::string shown_device(const CheckInputs& inputs, const std::string& otherwise) {
  return inputs.device_name.empty() ? otherwise : inputs.device_name;
}

SessionCheck untried_device_check(const CheckInputs& inputs) {
  SessionCheck check{.state = State::stop};
  if (inputs.tried != nullptr) {
    check.text = inputs.tried->failure;
    check.remedy = phrase("SessionChecks", "Fix the problem, then try the device again.");
    return check;
  }
  check.text = phrase("SessionChecks", "“%1” has not been tried yet.")
                   .with(shown_device(inputs, inputs.device));
  check.remedy = phrase("SessionChecks",
                        "Press “Try this device” while its handle is not held: the device is "
                        "opened, and the servo loop runs for a third of a second without force.");
  return check;
}

}  // namespace

std::optional<DeviceCapability> capability_of(const CheckInputs& inputs, const Protocol& protocol) {
  switch (kind_of_device(inputs.device)) {
    case DeviceKind::simulated:
      return SteppedRig(rig_settings_for(protocol, {}, inputs.device), 0).capability();
    case DeviceKind::pointer: {
      LatestValue<PointerSample> no_pointer{};
      return PointerDevice(no_pointer).capability();
    }
    case DeviceKind::attached:
      break;
  }
  if (inputs.tried == nullptr || !inputs.tried->failure.empty()) return {};
  return inputs.tried->capability;
}

bool has_motors(const DeviceCapability& device) { return device.actuated_degrees_of_freedom > 0; }

SessionCheck device_check(const CheckInputs& inputs, const Protocol& protocol) {
  SessionCheck check{};
  if (!inputs.device_blocker.empty()) {
    check.state = State::stop;
    check.text = inputs.device_blocker;
    check.remedy =
        phrase("SessionChecks", "Fix the problem, then press “Rescan”; or choose another device.");
    return check;
  }
  const std::optional<DeviceCapability> device = capability_of(inputs, protocol);
  if (!device) return untried_device_check(inputs);
  const std::vector<Phrase> complaints = complaints_about_device(protocol, *device);
  if (!complaints.empty()) {
    check.state = State::stop;
    check.text = complaints.front().as_sentence();
    check.remedy = phrase("SessionChecks",
                          "Choose another device, or lower the requirements in the protocol.");
    return check;
  }
  const std::optional<SessionRow> unfinished = resumed_row(inputs, protocol);
  if (inputs.mode == SessionMode::run) {
    if (const auto blocker = study_data_blocker(protocol, recorded_device(*device))) {
      check.state = State::stop;
      check.text = blocker->problem.as_sentence();
      check.remedy = blocker->remedy.as_sentence();
      return check;
    }
  }
  if (!has_motors(*device)) {
    check.text =
        phrase(
            "SessionChecks",
            "“%1” moves and presses the probe but exerts no force: the participant feels nothing.")
            .with(shown_device(inputs, device->name));
  } else {
    check.text =
        phrase("SessionChecks",
               "“%1” exerts up to %2 N at up to %3 Hz; the protocol requires %4 N at %5 Hz.")
            .with(shown_device(inputs, called(*device)), fixed(device->peak_force_N, 1),
                  fixed(device->maximum_rate_Hz, 0), fixed(protocol.force_limit_N, 1),
                  fixed(protocol.rate_Hz, 0));
  }
  const std::string before = other_device_before(inputs, unfinished, *device);
  if (!before.empty()) {
    check.state = State::look;
    check.text =
        phrase("SessionChecks", "%1 The session last ran on “%2”.").with(check.text, before);
    check.remedy = phrase("SessionChecks",
                          "Choose the device on which the session last ran, unless a change is "
                          "intended; a change is stored and stated in the report.");
  }
  return check;
}

}  // namespace asperity
