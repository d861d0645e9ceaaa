// Determines whether a protocol accepts a device before a session.

#include "app/session/rehearsal/rehearsed_device.h"

#include <algorithm>

#include "analysis/numbers/number_text.h"
#include "app/words/shell_word.h"

namespace asperity {
namespace {

/// Clocks of two computers agree better than this.
constexpr double kClocksDiffer_days = 1.0 / 24.0;

std::string days_text(double days) { return fixed(days, days < 100.0 ? 1 : 0); }

bool fails(const DeviceItem& item, const DeviceProfile& profile, const Protocol& protocol) {
  using ItemStatus = DeviceItem::Status;
  const DeviceQuantity* const quantity = device_quantity(item.name);
  if (quantity == nullptr) return item.status == ItemStatus::fail;  // it is done or not
  // Without a number it was not measured; what failed all the same, no limit can clear.
  if (!item.value) return item.status == ItemStatus::fail;
  if (quantity->is_timing && profile.is_simulated) return false;
  const auto asked = protocol.device_limits.find(item.name);
  if (asked != protocol.device_limits.end()) {
    return !keeps(*item.value, quantity->bound, asked->second);
  }
  const std::optional<double> usual =
      UsualLimits{.rate_Hz = protocol.rate_Hz, .is_simulated = profile.is_simulated}.of(item.name);
  if (!usual || keeps(*item.value, quantity->bound, *usual)) return false;
  // A lab may have held it to less; not where there is nothing to choose.
  return item.status == ItemStatus::fail || !quantity->takes_limit;
}

Phrase refusal_for_profile(const Protocol& protocol, const WantedDevice& device,
                           const std::optional<DeviceProfile>& profile,
                           const std::filesystem::path& study, const std::string& now_utc) {
  const std::string command = command_to_measure(device, study);
  if (!protocol.profile_maximum_age_days) {
    if (!protocol.refuses_rehearsal_warnings || profile || !device.has_motors) return {};
    return phrase("Rehearsal",
                  "the protocol requires a device that meets its limits, but the study has no "
                  "profile of \"%1\"; measure the device with %2")
        .with(name_of(device), command);
  }
  const std::string days = days_text(*protocol.profile_maximum_age_days);
  if (!profile) {
    return phrase("Rehearsal",
                  "the protocol requires a device measured within %1 days, but the study has no "
                  "profile of \"%2\"; measure the device with %3")
        .with(days, name_of(device), command);
  }
  const double age = age_days(*profile, now_utc);
  if (age > *protocol.profile_maximum_age_days) {
    return phrase("Rehearsal",
                  "the profile of \"%1\" is %2 days old, but the protocol allows at most %3; "
                  "measure the device again with %4")
        .with(name_of(device), days_text(age), days, command);
  }
  if (age < -kClocksDiffer_days) {
    return phrase("Rehearsal",
                  "the profile of \"%1\" is dated %2, which is in the future: correct the clock of "
                  "the computer, and measure the device again with %3")
        .with(name_of(device), profile->measured_utc, command);
  }
  if (const DeviceItem* const failed = failed_item(*profile, protocol)) {
    return phrase("Rehearsal",
                  "\"%1\" failed %2 when it was measured on %3, but the protocol requires a device "
                  "that passed; repair the device, and measure it again with %4")
        .with(name_of(device), failed->name, profile->measured_utc, command);
  }
  return {};
}

}  // namespace

std::string name_of(const WantedDevice& device) {
  if (!device.asked.empty()) return device.asked;
  return device.which.name + (device.which.serial.empty() ? "" : ':' + device.which.serial);
}

std::string command_to_measure(const WantedDevice& device, const std::filesystem::path& study) {
  return "asperity device-test " + shell_word(name_of(device)) + device.options + " --study " +
         shell_word(study.string());
}

const DeviceItem* failed_item(const DeviceProfile& profile, const Protocol& protocol) noexcept {
  const auto found =
      std::find_if(profile.items.begin(), profile.items.end(),
                   [&](const DeviceItem& item) { return fails(item, profile, protocol); });
  return found == profile.items.end() ? nullptr : &*found;
}

RehearsedDevice profiled_device(const Protocol& protocol, const WantedDevice& device,
                                const std::filesystem::path& study, const std::string& now_utc) {
  RehearsedDevice found{.profile = latest_profile(study, device.which)};
  found.refusal = refusal_for_profile(protocol, device, found.profile, study, now_utc);
  return found;
}

void compare(RehearsedDevice& device, const Protocol& protocol, const Rehearse& rehearse) {
  if (!device.profile) return;
  device.warnings = rehearse(*device.profile);
  if (!protocol.refuses_rehearsal_warnings || device.warnings.empty() || !device.refusal.empty()) {
    return;
  }
  device.refusal =
      phrase("Rehearsal", "requirements of the protocol that the device does not meet: %1. %2")
          .with(std::to_string(device.warnings.size()), device.warnings.front().text);
}

RehearsedDevice rehearsed_device(const Protocol& protocol, const WantedDevice& device,
                                 const std::filesystem::path& study, const std::string& now_utc,
                                 const Rehearse& rehearse) {
  RehearsedDevice found = profiled_device(protocol, device, study, now_utc);
  if (!found.refusal.empty()) throw PhrasedError(found.refusal);
  compare(found, protocol, rehearse);
  if (!found.refusal.empty()) throw PhrasedError(found.refusal);
  return found;
}

}  // namespace asperity
