// Declares the checks of a device before a session: its profile, the warnings for it, and whether the protocol accepts it.

#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analysis/words/phrase.h"
#include "app/profiles/device_profile.h"
#include "app/session/rehearsal/rehearsal_warning.h"
#include "app/words/phrase_of_error.h"
#include "protocols/design/protocol.h"

namespace asperity {

/// The requested device of a session, as far as the caller knows it.
struct WantedDevice {
  WhichDevice which{};
  /// Its name in --device, "simulated:delta.3", "falcon:042"; empty: the name that identifies `which`.
  std::string asked{};
  std::string options{};   ///< of its driver, in the form of a command: " --library FILE"
  bool has_motors = true;  ///< without motors there is no force to compare with a protocol
};

/// "simulated:delta.3", "falcon:042"
std::string name_of(const WantedDevice& device);
/// The command that measures this device and stores its profile in the study.
std::string command_to_measure(const WantedDevice& device, const std::filesystem::path& study);

struct RehearsedDevice {
  std::optional<DeviceProfile> profile{};
  std::vector<RehearsalWarning> warnings{};
  /// A sentence: why no session with a participant may begin on it; empty if one may.
  Phrase refusal{};
};

/// The latest profile of the device in the study, and whether the protocol accepts it. A profile is required if the
/// protocol limits its age or refuses warnings. If the protocol limits its age, it must not be older at `now_utc`, and no
/// item may fail: an item with a number is compared with the protocol's limit, or, if it failed in the test and the
/// protocol has no limit, with the usual limit at the protocol's rate, because the test may have used the limits of
/// another protocol. An item that failed without a number fails.
///
/// Errors: as `latest_profile`.
RehearsedDevice profiled_device(const Protocol& protocol, const WantedDevice& device,
                                const std::filesystem::path& study, const std::string& now_utc);

/// Compares the protocol with the device's profile if there is one. Sets the refusal if there are warnings and the
/// protocol refuses them.
using Rehearse = std::function<std::vector<RehearsalWarning>(const DeviceProfile&)>;
void compare(RehearsedDevice& device, const Protocol& protocol, const Rehearse& rehearse);

/// Both in the order of a session. Errors: PhrasedError with the refusal, before the comparison if the profile alone is
/// a reason; as `latest_profile`.
RehearsedDevice rehearsed_device(const Protocol& protocol, const WantedDevice& device,
                                 const std::filesystem::path& study, const std::string& now_utc,
                                 const Rehearse& rehearse);

/// The first item of the profile for which a session of this protocol would be refused; null if there is none.
const DeviceItem* failed_item(const DeviceProfile& profile, const Protocol& protocol) noexcept;

}  // namespace asperity
