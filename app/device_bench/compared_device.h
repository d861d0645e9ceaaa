// A device that protocols are checked against: sought once, compared with each, and what was not compared is said.

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/words/phrase.h"
#include "app/session/rehearsal/rehearsal.h"
#include "app/session/rehearsal/rehearsed_device.h"
#include "device/drivers.h"
#include "protocols/file/diagnostic.h"
#include "renderers/offline/friction_near_rest.h"

namespace asperity {

/// The result of comparing protocols with a named device.
struct SoughtDevice {
  WantedDevice wanted{};
  bool is_attached = false;  ///< its driver sees it
  /// A sentence: why no session could begin on it now, on this computer; empty where nothing is known against it.
  Phrase absence{};
  /// A sentence: why none could on any (a recording that cannot be read); empty where one could.
  Phrase refusal{};
  /// Of a simulated device that stands for a real one: DeviceCapability::not_known.
  std::vector<DeviceTrait> not_known{};
  /// What is known without a measurement: of a simulated device its properties, of others the driver's estimate of
  /// velocity.
  DampedResponse response{};
  /// 0 for one that measures without steps; nothing where it is unknown.
  std::optional<double> position_step_m{};
};
/// Looks for what --device names. A driver may open what it finds for a moment, to ask its name; nothing moves.
/// Errors: as simulated_settings; a driver that does not exist is an absence.
SoughtDevice sought_device(const std::string& device, const DriverOptions& options,
                           const DriverRegistry& drivers);

/// What check has to say about a protocol and a device.
struct DeviceComparison {
  std::string compared{};  ///< with what; empty: with nothing
  /// What falls short, where the protocol asks for it; what was not compared, and why, at its "/device".
  std::vector<Diagnostic> warnings{};
  Phrase refusal{};  ///< why no person's session begins; empty: one does
  std::optional<DeviceProfile> profile{};
};
/// Compares them as a session would at `now_utc`; without a study nothing is known of the device but what the simulated
/// one tells of itself. `file_name` is what its problems are said to be in. Never throws for what it finds.
DeviceComparison compare_with(const SoughtDevice& device, const Protocol& protocol,
                              const std::string& file_name,
                              const std::optional<std::filesystem::path>& study,
                              const std::string& now_utc, const ModelRegistry& models,
                              const StimuliCourse& course = {});

}  // namespace asperity
