// What a device was measured to be, on a date: its certificate.

#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "analysis/device_response.h"
#include "app/words/phrase.h"
#include "device/device_trait.h"

namespace asperity {

/// One quantity of a device, or one thing that it has to do.
struct DeviceItem {
  enum class Status { pass, fail, not_measured };
  enum class Bound { at_most, at_least };

  std::string name{};  ///< its unit in it: "friction_N", "lateness_p99_s", "zero_after_stop"
  Status status = Status::not_measured;
  std::optional<double> value{};  ///< the worst of the axes; nothing for what is done or not
  std::vector<double> by_axis{};  ///< x, y, z, where they were measured apart
  /// The limit that it was compared with. Without one the number is reported and not judged.
  std::optional<double> limit{};
  Bound bound = Bound::at_most;
  Phrase text{};  ///< a sentence: what was done, or why nothing could be

  /// Measured without a limit, which is shown as "no limit": neither good nor bad.
  bool is_only_told() const noexcept { return status == Status::pass && value && !limit; }
  /// Limited, and not measured.
  bool is_open() const noexcept { return status == Status::not_measured && limit; }
};

/// As it stands in a profile.
const char* text_of(DeviceItem::Status status) noexcept;
/// How it came out, in the words of terminal, window and profile: "pass", "fail", "not measured", "no limit".
const char* outcome_of(const DeviceItem& item) noexcept;

/// What an item with a number is: the kind that can be held to a limit.
struct DeviceQuantity {
  const char* name = nullptr;  ///< the item's
  DeviceItem::Bound bound = DeviceItem::Bound::at_most;
  /// Characterises the computer as much as the device: of a simulated one it is reported and not judged.
  bool is_timing = false;
  bool takes_limit = true;  ///< false: it is met or not, without a number
  /// The trait that it measures, where one may be known of one device and unknown of another.
  std::optional<DeviceTrait> trait{};
};
/// All there are, in the order of a profile.
std::span<const DeviceQuantity> device_quantities() noexcept;
/// Null where no item with a number is called so.
const DeviceQuantity* device_quantity(std::string_view name) noexcept;
/// The limits of items where no others are set.
struct UsualLimits {
  double rate_Hz = 1000.0;  ///< that was asked for
  bool is_simulated = false;
  /// Nothing where a number is reported and not judged.
  std::optional<double> of(std::string_view item) const noexcept;
};
/// Whether a number is on its side of a limit.
bool keeps(double value, DeviceItem::Bound bound, double limit) noexcept;

/// How far the handle answered to tones along one axis.
struct AxisResponse {
  std::string axis{};                      ///< "x", "y" or "z"
  std::vector<FrequencyResponse> tones{};  ///< frequencies ascend
};

/// A device as `device-test` found it. Format: docs/formats/device_profile.md.
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
  double force_N = 0.0;                 ///< no force was stronger
  glm::dvec3 workspace_minimum_m{0.0};  ///< as the driver reports it
  glm::dvec3 workspace_maximum_m{0.0};
  /// What the handle reached when a person moved it along its borders.
  std::optional<glm::dvec3> reached_minimum_m{};
  std::optional<glm::dvec3> reached_maximum_m{};
  std::vector<DeviceItem> items{};
  std::vector<AxisResponse> responses{};  ///< of the axes that were driven by tones
  /// Of a simulated device that stands for a real one: DeviceCapability::not_known.
  std::vector<DeviceTrait> not_known{};

  /// "delta.3" of a simulated device that stands for one, otherwise empty.
  std::string stands_for() const;
  /// All that is not in `not_known`.
  std::vector<DeviceTrait> known() const;
  /// Whether the item measures an unknown trait: of a simulated model of the device it is not measured then.
  bool is_unknown(std::string_view item) const noexcept;
  /// Null where there is no such item.
  const DeviceItem* item(std::string_view name) const noexcept;
  /// Nothing where it was not measured.
  std::optional<double> value(std::string_view name) const noexcept;
  bool has_failed() const noexcept;
  bool has_open_limit() const noexcept;
};

/// Removes the numbers of traits that are unknown of the device that a simulated one models, and remarks on it.
void leave_out_unknown(DeviceProfile& profile);

/// The document, indented, with a line's end.
std::string json_text_of(const DeviceProfile& profile);
/// In a profile by an earlier version of a simulated model of a device, unknown traits are removed as well.
/// Errors: std::runtime_error with a sentence that names `origin` and what is wrong with it.
DeviceProfile profile_from_json(const std::string& text, const std::string& origin);

/// The study's profiles lie in its folder `profiles`, one file each:
/// "falcon-042-20260101T101500Z.json", "simulated-Novint_Falcon-20260101T101500Z.json".
std::filesystem::path profile_path(const std::filesystem::path& study,
                                   const DeviceProfile& profile);

/// What is empty may be anything.
struct WhichDevice {
  std::string name{};  ///< the driver's
  std::string model{};
  std::string serial{};
};
/// What the study's folder of profiles has.
struct KeptProfiles {
  std::vector<DeviceProfile> profiles{};  ///< of this device, the latest first
  /// A sentence for each file that cannot be read and is this device's, or does not even tell whose it is.
  std::vector<std::string> complaints{};
};
/// The profiles that the study has of this device. A profile without serial is that of every device of its
/// driver and model.
KeptProfiles profiles_in(const std::filesystem::path& study, const WhichDevice& device);
/// The first of them; nothing where there is none.
/// Errors: std::runtime_error with the first complaint: a file that cannot be read may be the latest of this device,
/// and no session is compared with an older one unsaid.
std::optional<DeviceProfile> latest_profile(const std::filesystem::path& study,
                                            const WhichDevice& device);

/// How long before `now_utc` the device was measured. Errors: std::invalid_argument for what is no date.
double age_days(const DeviceProfile& profile, const std::string& now_utc);

}  // namespace asperity
