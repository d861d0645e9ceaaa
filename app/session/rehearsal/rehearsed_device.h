// A device before a session: what it was last measured to be, what of the plan is beyond that, and whether the
// protocol takes it.

#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/profiles/device_profile.h"
#include "app/session/rehearsal/rehearsal.h"
#include "app/words/phrase.h"
#include "protocols/design/protocol.h"

namespace asperity {

/// The device that a session is to run on, as the caller knows it.
struct WantedDevice {
  WhichDevice which{};
  /// As --device names it, "simulated:delta.3", "falcon:042"; empty: as `which` identifies it.
  std::string asked{};
  std::string options{};   ///< of its driver, as a command takes them: " --library FILE"
  bool has_motors = true;  ///< one without gives no force that could fall short of a protocol
};

/// "simulated:delta.3", "falcon:042"
std::string name_of(const WantedDevice& device);
/// The command that measures this device and keeps its profile with the study.
std::string command_to_measure(const WantedDevice& device, const std::filesystem::path& study);

struct RehearsedDevice {
  std::optional<DeviceProfile> profile{};
  std::vector<RehearsalWarning> warnings{};
  /// A sentence: why no person's session begins on it; empty: one does.
  Phrase refusal{};
};

/// The latest profile that the study has of the device, and whether the protocol takes it so: there has to be one
/// where the protocol limits its age or refuses warnings, and where it limits its age, it has to be that
/// young at `now_utc` and no item may fail. Items with a number are held to the protocol's own limits, and where it has
/// none to the usual ones at its rate, if they failed: a verdict is one on limits, which may have been another
/// protocol's. What failed without a number fails.
///
/// Errors: as `latest_profile`.
RehearsedDevice profiled_device(const Protocol& protocol, const WantedDevice& device,
                                const std::filesystem::path& study, const std::string& now_utc);

/// Compares the protocol with the device's profile, where there is one, and refuses for what comes of it where the
/// protocol does.
using Rehearse = std::function<std::vector<RehearsalWarning>(const DeviceProfile&)>;
void compare(RehearsedDevice& device, const Protocol& protocol, const Rehearse& rehearse);

/// Both, as a session asks it. Errors: PhrasedError with the refusal, before a comparison that takes its time where the
/// profile suffices; as `latest_profile`.
RehearsedDevice rehearsed_device(const Protocol& protocol, const WantedDevice& device,
                                 const std::filesystem::path& study, const std::string& now_utc,
                                 const Rehearse& rehearse);

/// The first item of the profile that a session of this protocol would be refused for; null where there is none.
const DeviceItem* failed_item(const DeviceProfile& profile, const Protocol& protocol) noexcept;

}  // namespace asperity
