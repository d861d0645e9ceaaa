// Stores the measured properties of a device, with the date of the measurement.

#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "analysis/signals/device_response.h"
#include "analysis/words/phrase.h"
#include "device/device_trait.h"

namespace asperity {

/// One quantity of a device, or one function that it has to perform.
struct DeviceItem {
  enum class Status { pass, fail, not_measured };
  enum class Bound { at_most, at_least };

  std::string name{};  ///< includes the unit: "friction_N", "lateness_p99_s", "zero_after_stop"
  Status status = Status::not_measured;
  std::optional<double> value{};  ///< the worst of the axes; absent for a function without a number
  std::vector<double> by_axis{};  ///< x, y, z, where they were measured separately
  /// The limit that it was compared with. Without one the number is reported and not evaluated.
  std::optional<double> limit{};
  Bound bound = Bound::at_most;
  Phrase text{};  ///< a sentence: what was done, or why nothing could be done

  /// Measured without a limit, which is displayed as "no limit": neither passed nor failed.
  bool is_only_told() const noexcept { return status == Status::pass && value && !limit; }
  /// Has a limit, and was not measured.
  bool is_open() const noexcept { return status == Status::not_measured && limit; }
};

/// As written in a profile.
const char* text_of(DeviceItem::Status status) noexcept;
/// The outcome as shown by terminal, window and profile: "pass", "fail", "not measured", "no
/// limit".
const char* outcome_of(const DeviceItem& item) noexcept;

/// An item with a number, which can be compared with a limit.
struct DeviceQuantity {
  const char* name = nullptr;  ///< the item's
  DeviceItem::Bound bound = DeviceItem::Bound::at_most;
  /// Characterises the computer as much as the device: for a simulated device it is reported and
  /// not evaluated.
  bool is_timing = false;
  bool takes_limit = true;  ///< false: it is fulfilled or not, without a number
  /// The trait that it measures, where that trait may be unknown for some devices.
  std::optional<DeviceTrait> trait{};
};
/// All quantities, in the order of a profile.
std::span<const DeviceQuantity> device_quantities() noexcept;
/// Null where no item with a number has this name.
const DeviceQuantity* device_quantity(std::string_view name) noexcept;
/// The default limits of items.
struct UsualLimits {
  double rate_Hz = 1000.0;  ///< the requested rate
  bool is_simulated = false;
  /// Nothing where a number is reported and not evaluated.
  std::optional<double> of(std::string_view item) const noexcept;
};
/// Whether a number complies with a limit.
bool keeps(double value, DeviceItem::Bound bound, double limit) noexcept;

/// The response of the handle to tones along one axis.
struct AxisResponse {
  std::string axis{};                      ///< "x", "y" or "z"
  std::vector<FrequencyResponse> tones{};  ///< frequencies ascend
};

/// The measurements of a device by `device-test`. Format: docs/formats/device_profile.md.
struct DeviceProfile {
  std::string name{};  ///< the driver's
  std::string model{};
  std::string serial{};  ///< empty where the device reports none
  bool is_simulated = false;
  std::string measured_utc{};  ///< when the measurement ended, "2026-01-01T00:00:00.000Z"
  std::string program_version{};
  std::string program_commit{};
  double rate_Hz = 0.0;  ///< of the servo loop
  std::string scheduling{};
  double force_N = 0.0;                 ///< maximum of all forces
  glm::dvec3 workspace_minimum_m{0.0};  ///< as reported by the driver
  glm::dvec3 workspace_maximum_m{0.0};
  /// The range that the handle reached when a person moved it along the borders.
  std::optional<glm::dvec3> reached_minimum_m{};
  std::optional<glm::dvec3> reached_maximum_m{};
  std::vector<DeviceItem> items{};
  std::vector<AxisResponse> responses{};  ///< of the axes that were driven by tones
  /// For a simulated device that models a real one: DeviceCapability::not_known.
  std::vector<DeviceTrait> not_known{};

  /// "delta.3" for a simulated device that models one, otherwise empty.
  std::string stands_for() const;
  /// All traits that are not in `not_known`.
  std::vector<DeviceTrait> known() const;
  /// Whether the item measures an unknown trait: it is then not measured on a simulated model of
  /// the device.
  bool is_unknown(std::string_view item) const noexcept;
  /// Null where there is no such item.
  const DeviceItem* item(std::string_view name) const noexcept;
  /// Nothing where it was not measured.
  std::optional<double> value(std::string_view name) const noexcept;
  bool has_failed() const noexcept;
  bool has_open_limit() const noexcept;
};

/// Removes the numbers of traits that are unknown for the device that a simulated one models, and
/// remarks on it.
void leave_out_unknown(DeviceProfile& profile);

/// The document, indented, with a final line break.
std::string json_text_of(const DeviceProfile& profile);
/// Errors: std::runtime_error with a sentence that names `origin` and its problem.
DeviceProfile profile_from_json(const std::string& text, const std::string& origin);

/// The study's profiles lie in its folder `profiles`, one file each:
/// "falcon-042-20260101T101500Z.json", "simulated-Novint_Falcon-20260101T101500Z.json".
std::filesystem::path profile_path(const std::filesystem::path& study,
                                   const DeviceProfile& profile);

/// An empty member matches any device.
struct WhichDevice {
  std::string name{};  ///< the driver's
  std::string model{};
  std::string serial{};
};
/// The profiles in the study's folder.
struct KeptProfiles {
  std::vector<DeviceProfile> profiles{};  ///< of this device, in descending order of time
  /// A sentence for each file that cannot be read and is this device's, or does not identify its
  /// device.
  std::vector<std::string> complaints{};
};
/// The profiles that the study has of this device. A profile without a serial number applies to
/// every device of its driver and model.
KeptProfiles profiles_in(const std::filesystem::path& study, const WhichDevice& device);
/// The latest of them; nothing where there is none.
/// Errors: std::runtime_error with the first complaint: a file that cannot be read may be the
/// latest profile of this device, and a session is not compared with an older one without notice.
std::optional<DeviceProfile> latest_profile(const std::filesystem::path& study,
                                            const WhichDevice& device);

/// The time from the measurement of the device to `now_utc`, in days. Errors: std::invalid_argument
/// for a text that is not a date.
double age_days(const DeviceProfile& profile, const std::string& now_utc);

}  // namespace asperity
