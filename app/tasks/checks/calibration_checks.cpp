// Groups the warnings of a rehearsal by kind, and shows the first of each with the number of others.

#include "app/tasks/checks/calibration_checks.h"

#include <algorithm>
#include <optional>
#include <string>

#include "app/device_bench/device_choice.h"
#include "app/session/rig/clock.h"
#include "app/session/session_setup.h"
#include "app/session/stimulus_builder.h"
#include "app/tasks/checks/device_check.h"
#include "app/tasks/session_run.h"
#include "app/tasks/warnings/rehearsed_stimuli.h"
#include "app/words/device_remarks.h"
#include "app/words/time_ago.h"
#include "device/simulated_models.h"

namespace asperity {
namespace {

using State = SessionCheck::State;

/// One line for each kind of warning: the first one, and the number of other stimuli with the same.
std::vector<SessionCheck> lines_of(const std::vector<RehearsalWarning>& warnings) {
  std::vector<SessionCheck> lines{};
  std::vector<std::string> kinds{};
  for (const RehearsalWarning& warning : warnings) {
    if (std::find(kinds.begin(), kinds.end(), warning.id) != kinds.end()) continue;
    kinds.push_back(warning.id);
    const auto alike =
        std::count_if(warnings.begin(), warnings.end(),
                      [&warning](const RehearsalWarning& one) { return one.id == warning.id; });
    SessionCheck line{.id = "rehearsal",
                      .title = phrase("SessionChecks", "Rehearsal"),
                      .state = State::look,
                      .text = warning.text};
    if (alike > 1) {
      line.text = phrase("SessionChecks", "%1 Further warnings of this kind: %2.")
                      .with(warning.text, std::to_string(alike - 1));
    }
    lines.push_back(line);
  }
  if (!lines.empty()) {
    lines.back().remedy = phrase("SessionChecks",
                                 "Choose another device, or stimuli that this one can render; "
                                 "otherwise these warnings are stored with the session.");
  }
  return lines;
}

bool is_of_limits(const RehearsalWarning& warning) {
  return warning.id.starts_with("limit_") || warning.id.starts_with("unmeasured_");
}

}  // namespace

std::vector<SessionCheck> calibration_checks(const CheckInputs& inputs, const Protocol& protocol,
                                             const ModelRegistry& models,
                                             const std::stop_token& stop,
                                             const std::function<void(double)>& progress) {
  if (inputs.mode == SessionMode::simulate) {
    return {fine_check(
        phrase("SessionChecks", "Not needed: the simulated device has no calibration."))};
  }
  WantedDevice wanted{.which = which_device(inputs.device),
                      .asked = inputs.device,
                      .options = as_command_options(inputs.driver_options)};
  const std::optional<DeviceCapability> device = capability_of(inputs, protocol);
  if (device) {
    wanted.which = {device->name, device->model, device->serial};
    wanted.has_motors = has_motors(*device);
  }
  StimulusBuilder builder(models, inputs.study);
  const Rehearse rehearse = [&](const DeviceProfile& profile) {
    return rehearse_once(inputs.rehearsal.get(), protocol, profile, inputs.study, builder,
                         {.stop = stop, .progress = progress});
  };
  const std::string now_utc = SystemClock(0).utc();
  const RehearsedDevice found = rehearsed_device(protocol, wanted, inputs.study, now_utc, rehearse);
  if (!found.profile) {
    const bool is_simulated_model = device && !model_stood_for(device->model).empty();
    if (kind_of_device(inputs.device) == DeviceKind::simulated && !is_simulated_model) {
      return {fine_check(
          phrase("SessionChecks", "Not needed: the simulated device has no calibration."))};
    }
    if (device && !has_motors(*device)) {
      return {fine_check(phrase("SessionChecks", "Not needed: the device exerts no force."))};
    }
    return {{.state = State::look,
             .text = phrase("SessionChecks",
                            "The study has no profile of this device, so it was not checked "
                            "whether the device can render these stimuli."),
             .remedy = phrase("SessionChecks",
                              "Measure the device once while its handle is not held: asperity "
                              "device-test \"%1\" --study \"%2\"")
                           .with(inputs.device, inputs.study.string())}};
  }
  const Phrase age = phrase("SessionChecks", "Measured %1")
                         .with(time_ago(kHoursADay * age_days(*found.profile, now_utc)));
  const std::vector<SessionCheck> beyond = lines_of(found.warnings);
  // Warnings about limits come first.
  const bool breaks_limits = !found.warnings.empty() && is_of_limits(found.warnings.front());
  const bool is_beyond = !found.warnings.empty() && !is_of_limits(found.warnings.back());
  const std::vector<DeviceTrait> uncompared = not_compared(found.profile->not_known);
  SessionCheck profile{};
  if (is_beyond) {
    profile.text =
        phrase("SessionChecks", "%1; some stimuli exceed the capabilities of the device.")
            .with(age);
  } else if (breaks_limits) {
    const Phrase text = uncompared.empty()
                            ? phrase("SessionChecks",
                                     "%1; every stimulus is within the capabilities of the device, "
                                     "but the device does not meet the protocol's limits.")
                            : phrase("SessionChecks",
                                     "%1; every stimulus is within the known capabilities of the "
                                     "device, but the device does not meet the protocol's limits.");
    profile.text = text.with(age);
  } else {
    const Phrase text =
        uncompared.empty()
            ? phrase("SessionChecks",
                     "%1; every stimulus is within the capabilities of the device.")
            : phrase("SessionChecks",
                     "%1; every stimulus is within the known capabilities of the device.");
    profile.text = text.with(age);
  }
  if (!uncompared.empty()) {
    profile.state = State::look;
    profile.text = phrase("SessionChecks", "%1 Unknown for %2 and not compared: %3.")
                       .with(profile.text, found.profile->stands_for(), listed_traits(uncompared));
    profile.remedy = phrase("SessionChecks", "Measure a real device as soon as one is available.");
  }
  // An item beyond a limit of the protocol has a separate line.
  DeviceProfile unlimited = *found.profile;
  std::erase_if(unlimited.items, [&protocol](const DeviceItem& item) {
    return protocol.device_limits.contains(item.name);
  });
  if (failed_item(unlimited, protocol) != nullptr) {
    profile.state = State::look;
    profile.text = phrase("SessionChecks", "%1 The device failed an item of the measurement.")
                       .with(profile.text);
    profile.remedy =
        phrase("SessionChecks", "Check the profile of the device, and measure the device again.");
  }
  std::vector<SessionCheck> lines{profile};
  lines.insert(lines.end(), beyond.begin(), beyond.end());
  return lines;
}

}  // namespace asperity
