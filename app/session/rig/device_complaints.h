// The reported problems of a device, as they are shown and as they are reported and stored.

#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace asperity {

/// Takes the problems that a device reports (HapticDevice::complaint), and determines which of them are new.
///
/// Every change is shown. Reported to the user and stored is when it begins, when it is over, and every ten
/// seconds at most when its words change: a count in them would fill the store.
///
/// Times are those of one clock, and do not go back.
class DeviceComplaints final {
 public:
  static constexpr std::int64_t kHeardEvery_ns = 250'000'000;
  static constexpr std::int64_t kToldEvery_ns = 10'000'000'000;

  struct News {
    bool is_new = false;      ///< other words than were heard before: to be shown
    bool turns = false;       ///< from well to a complaint, or back
    bool is_to_tell = false;  ///< what was heard now, empty where all is well again
  };

  /// It is time to ask the device again.
  bool is_due(std::int64_t now_ns) const noexcept;
  News hear(const std::string& complaint, std::int64_t now_ns);

 private:
  std::string heard_{};
  std::string told_{};
  std::optional<std::int64_t> heard_ns_{};
  std::int64_t told_ns_ = 0;
};

}  // namespace asperity
