// Tracks the problems that a device reports, for display, reports and storage.

#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace asperity {

/// Takes the problems that a device reports (HapticDevice::complaint), and determines which of them
/// are new.
///
/// Every change is displayed. A problem is reported to the user and stored when it begins, when it
/// is over, and at most every ten seconds when its text changes: a count in the text would
/// otherwise fill the store.
///
/// Times come from one clock and do not decrease.
class DeviceComplaints final {
 public:
  static constexpr std::int64_t kHeardEvery_ns = 250'000'000;
  static constexpr std::int64_t kToldEvery_ns = 10'000'000'000;

  struct News {
    bool is_new = false;  ///< a different text from the last one: to be displayed
    bool turns = false;   ///< a problem begins or ends
    /// The current problem is to be reported and stored; its text is empty where there is none.
    bool is_to_tell = false;
  };

  /// Whether the device should be queried again.
  bool is_due(std::int64_t now_ns) const noexcept;
  News hear(const std::string& complaint, std::int64_t now_ns);

 private:
  std::string heard_{};
  std::string told_{};
  std::optional<std::int64_t> heard_ns_{};
  std::int64_t told_ns_ = 0;
};

}  // namespace asperity
