// A device that protocols are checked against: sought once, compared with each.

#include "app/device_bench/compared_device.h"

#include <algorithm>
#include <array>
#include <exception>
#include <functional>

#include "analysis/numbers/number_text.h"
#include "app/device_bench/device_choice.h"
#include "app/profiles/device_kind.h"
#include "app/session/rehearsal/friction_rehearsal.h"
#include "app/session/rehearsal/position_step_rehearsal.h"
#include "app/session/rig/recorded_hand.h"
#include "app/words/device_remarks.h"
#include "app/words/text_parts.h"
#include "device/simulated_device.h"
#include "device/simulated_models.h"
#include "device/virtual_hand.h"
#include "protocols/file/json_document.h"

namespace asperity {
namespace {

constexpr const char* kReplay = "replay";

/// The items that stimuli are compared with; in addition rate and workspace, which every profile has.
constexpr std::array kComparedItems{
    "friction_N",        "force_resolution_N", "position_resolution_m", "damping_N_s_per_m",
    "stiffness_N_per_m", "latency_s",          "moving_mass_kg"};

std::string in_quotation_marks(const std::string& word) { return '"' + word + '"'; }

DeviceCapability simulated_capability(const SimulatedDeviceSettings& settings) {
  VirtualHand hand(HandHabits{}, Random(0));
  return SimulatedDevice(hand, settings).capability();
}

bool is_known_of(const DeviceCapability& capability, DeviceTrait trait) {
  return std::find(capability.not_known.begin(), capability.not_known.end(), trait) ==
         capability.not_known.end();
}

/// The properties of a simulated device: those of its virtual hand where it stands for no device in which they are
/// unknown.
DampedResponse response_of(const SimulatedDeviceSettings& settings,
                           const DeviceCapability& capability) {
  const auto is_known = [&capability](DeviceTrait trait) { return is_known_of(capability, trait); };
  DampedResponse response{.latency_s = settings.sensor.latency_s,
                          .velocity = settings.sensor.velocity};
  if (is_known(DeviceTrait::moving_mass)) response.moving_mass_kg = settings.hand.mass_kg;
  if (is_known(DeviceTrait::damping)) response.damping_N_s_per_m = settings.hand.damping_N_s_per_m;
  return response;
}

using Warn = std::function<void(const Phrase& sentence)>;

/// What no measurement of a simulated device will tell of the one that it stands for.
void tell_unknown(const SoughtDevice& device, const Warn& warn) {
  const std::vector<DeviceTrait> missing = not_compared(device.not_known);
  if (missing.empty()) return;
  const std::string real(model_stood_for(device.wanted.which.model));
  warn(phrase("Protocols",
              "these properties of %1, which %2 models, are unknown: %3; no stimulus was compared "
              "with them. Measure the real device as soon as it is available")
           .with(real, in_quotation_marks(name_of(device.wanted)), listed_traits(missing)));
}

void look_for(const Driver& driver, const std::string& which, const DriverOptions& options,
              const DriverRegistry& drivers, SoughtDevice& sought) {
  const DriverSurvey survey = drivers.survey(driver, options);
  if (!survey.blocker.empty()) {
    sought.absence = survey.blocker;
    return;
  }
  try {
    const AttachedDevice found = choose_attached(driver.id, survey.attached, which);
    sought.wanted.which.serial = found.serial;
    sought.is_attached = true;
  } catch (const std::exception& error) {
    sought.absence = phrase_of(error);
  }
}

/// Behind "the study has no profile of".
Phrase words_for(const SoughtDevice& device) {
  const WhichDevice& which = device.wanted.which;
  if (!device.is_attached) return in_quotation_marks(name_of(device.wanted));
  return phrase("Protocols", "the attached device %1")
      .with(which.name + (which.serial.empty() ? "" : ' ' + which.serial));
}

/// What the profile leaves open, beside what nobody knows.
void tell_gaps(const DeviceProfile& profile, const Protocol& protocol, const std::string& now_utc,
               const Warn& warn) {
  std::vector<std::string> missing{};
  for (const char* const item : kComparedItems) {
    if (!profile.value(item) && !profile.is_unknown(item)) missing.emplace_back(item);
  }
  if (!missing.empty()) {
    warn(phrase("Protocols",
                "the profile has no value for %1; no stimulus was compared with the missing "
                "values. Measure the device again")
             .with(comma_separated(missing)));
  }
  if (age_days(profile, now_utc) < 0.0 && !protocol.profile_maximum_age_days) {
    warn(phrase("Protocols",
                "the profile is dated %1, which is in the future; correct the clock of the "
                "computer, and measure the device again")
             .with(profile.measured_utc));
  }
}

/// What is compared without a profile, before "no stimulus was compared".
Phrase exception_for(const FrictionRehearsal& friction, bool has_position_step) {
  if (friction.not_compared.empty()) {
    return has_position_step ? phrase("Protocols", "except for friction and position steps, ")
                             : phrase("Protocols", "except for friction, ");
  }
  if (friction.has_compared) {
    return has_position_step
               ? phrase("Protocols", "except for the friction of some stimuli and position steps, ")
               : phrase("Protocols", "except for the friction of some stimuli, ");
  }
  return has_position_step ? phrase("Protocols", "except for position steps, ") : Phrase();
}

}  // namespace

SoughtDevice sought_device(const std::string& device, const DriverOptions& options,
                           const DriverRegistry& drivers) {
  SoughtDevice sought{.wanted = {.which = which_device(device),
                                 .asked = device,
                                 .options = as_command_options(options)}};
  if (const auto settings = simulated_settings(device)) {
    const DeviceCapability capability = simulated_capability(*settings);
    // Its model tells one profile from another.
    sought.wanted.which = {capability.name, capability.model, capability.serial};
    sought.not_known = capability.not_known;
    sought.response = response_of(*settings, capability);
    if (is_known_of(capability, DeviceTrait::position_step)) {
      sought.position_step_m = capability.position_resolution_m;
    }
    return sought;
  }
  const std::size_t colon = device.find(':');
  const std::string which = colon == std::string::npos ? "" : device.substr(colon + 1);
  const Driver* const driver = drivers.find(device.substr(0, colon));
  if (driver == nullptr) {
    std::string names{};
    for (const Driver& known : drivers.drivers()) names += (names.empty() ? "" : ", ") + known.id;
    sought.absence = phrase("Protocols", "there is no device %1; choose one of: %2")
                         .with(in_quotation_marks(device), names);
    return sought;
  }
  sought.wanted.has_motors = driver->has_motors;
  sought.response.velocity = driver->velocity;
  sought.position_step_m = driver->position_step_m;
  if (driver->id == kReplay) {
    try {
      DriverOptions with_reader = options;
      with_reader.recorded_hand = recorded_hand;
      (void)driver->open(which, with_reader);
    } catch (const std::exception& error) {
      sought.refusal = phrase_of(error);
    }
    return sought;
  }
  // The mouse is there wherever a window is.
  if (kind_of_device(device) == DeviceKind::attached) {
    look_for(*driver, which, options, drivers, sought);
  }
  return sought;
}

DeviceComparison compare_with(const SoughtDevice& device, const Protocol& protocol,
                              const std::string& file_name,
                              const std::optional<std::filesystem::path>& study,
                              const std::string& now_utc, const ModelRegistry& models,
                              const StimuliCourse& course) {
  DeviceComparison comparison{.refusal = device.refusal};
  const JsonDocument document(protocol.source, file_name);
  const auto warn_at = [&](const std::string& pointer, const Phrase& sentence) {
    comparison.warnings.push_back(document.at_key(pointer, sentence));
  };
  const Warn warn = [&](const Phrase& sentence) { warn_at("/device", sentence); };
  const std::string name = in_quotation_marks(name_of(device.wanted));
  const bool is_simulated = kind_of_device(name_of(device.wanted)) == DeviceKind::simulated;
  if (!device.absence.empty()) {
    warn(phrase("Protocols", "no session can start on %1 at present: %2")
             .with(name, device.absence));
  }
  if (!comparison.refusal.empty()) return comparison;
  const auto warn_of = [&](const std::vector<RehearsalWarning>& found) {
    for (const RehearsalWarning& warning : found) {
      warn_at(warning.pointer, warning.text);
    }
  };
  // What needs no measurement.
  FrictionRehearsal friction{};
  if (device.wanted.has_motors) {
    friction = rehearse_friction(protocol, models, device.response);
  }
  if (device.wanted.has_motors && !device.position_step_m) {
    warn_of(unknown_step_warnings(protocol, models));
  }
  const auto warn_without_profile = [&](StimulusBuilder& builder) {
    warn_of(friction.warnings);
    warn_of(friction.not_compared);
    if (!device.wanted.has_motors || !device.position_step_m) return;
    warn_of(position_step_warnings(protocol, builder, *device.position_step_m));
  };
  const Phrase except_known = exception_for(friction, device.position_step_m.value_or(0.0) > 0.0);
  const std::string of_itself = "the force and the rate of " + name;
  if (is_simulated) comparison.compared = "compared with " + of_itself;
  tell_unknown(device, warn);
  if (!study) {
    if (device.wanted.has_motors) {
      warn(phrase("Protocols",
                  "%1no stimulus was compared with %2: the profile of a device is stored in a "
                  "study; name the study with --study DIR")
               .with(except_known, name));
    }
    StimulusBuilder without_files(models, {});
    warn_without_profile(without_files);
  } else {
    try {
      RehearsedDevice found = profiled_device(protocol, device.wanted, *study, now_utc);
      StimulusBuilder builder(models, *study);
      compare(found, protocol, [&](const DeviceProfile& profile) {
        return rehearse_on_device(protocol, profile, builder, course);
      });
      warn_of(found.warnings);
      if (!found.profile) warn_without_profile(builder);
      if (found.profile) {
        comparison.compared =
            "compared with the profile of " + name + ", measured on " +
            found.profile->measured_utc +
            (found.profile->serial.empty() ? "" : ", serial " + found.profile->serial) +
            (is_simulated ? ", and with " + of_itself
                          : "; a session compares the force and the rate when it opens the device");
        tell_gaps(*found.profile, protocol, now_utc, warn);
        warn_of(
            rehearse_friction(protocol, models, damped_response_of(*found.profile)).not_compared);
      } else if (device.wanted.has_motors) {
        warn(phrase("Protocols",
                    "the study has no profile of %1: %2no stimulus and no limit of the protocol "
                    "was compared with it; measure the device with %3")
                 .with(words_for(device), except_known, command_to_measure(device.wanted, *study)));
      }
      comparison.profile = std::move(found.profile);
      comparison.refusal = found.refusal;
    } catch (const std::exception& error) {
      comparison.refusal = phrase_of(error);
    }
  }
  if (!device.wanted.has_motors) {
    warn(phrase("Protocols",
                "%1 exerts no force: no stimulus was compared with it; to compare them, name a "
                "device with motors")
             .with(name));
  }
  return comparison;
}

}  // namespace asperity
