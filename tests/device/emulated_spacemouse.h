// SpaceMice without hardware: the wire's other end, for the driver as it is.

#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "tests/device/emulated_usb.h"

namespace asperity {

/// The bytes of a report of three axes, or of six.
std::vector<std::uint8_t> report_of(std::uint8_t number, const std::vector<int>& deflections);

struct EmulatedSpaceMouseSettings {
  int port = 2;  ///< its place is "usb 1-PORT"
  std::uint16_t vendor = 0x256f;
  std::uint16_t product = 0xc635;  // Compact
  std::string serial{};
  /// Of each of its interfaces: 0, or 1 and 2 of keyboards and mice.
  std::vector<int> protocols{0};
};

/// A HID device that says what it is told to, and the kernel's driver that has it until somebody takes it.
///
/// Threads: any.
class EmulatedSpaceMouse final {
 public:
  EmulatedSpaceMouse(EmulatedBus& bus, EmulatedSpaceMouseSettings settings);
  ~EmulatedSpaceMouse();
  EmulatedSpaceMouse(const EmulatedSpaceMouse&) = delete;
  EmulatedSpaceMouse& operator=(const EmulatedSpaceMouse&) = delete;

  /// Once, after all that it has still to say.
  void say(std::vector<std::uint8_t> report, std::size_t interface = 0);
  /// In turn, 8 ms apart, as a deflected cap does; until the next `hold`. Empty: it says nothing, as at rest.
  void hold(std::vector<std::vector<std::uint8_t>> reports, std::size_t interface = 0);

  void unplug();
  void plug_in();
  /// Nobody may open it any more.
  void forbid();
  /// The next transfers fail on the bus.
  void fail_transfers(int count);

  bool is_held(std::size_t interface = 0) const;         ///< somebody has claimed it
  bool is_the_kernels(std::size_t interface = 0) const;  ///< its own driver has it
  bool has_said_all() const;
  int opened() const;  ///< how often somebody began to talk to it

 private:
  struct Interface {
    const UMockdevIoctlClient* holder = nullptr;
    bool is_the_kernels = true;
    std::deque<std::vector<std::uint8_t>> to_say{};
    std::vector<std::vector<std::uint8_t>> held{};
    std::size_t next_held = 0;
    std::chrono::steady_clock::time_point said{};
  };

  void answer_ioctl(UMockdevIoctlClient* client);
  int driver_of(UMockdevIoctlData* argument);
  int connect_or_disconnect(UMockdevIoctlData* argument);
  int claim(UMockdevIoctlClient* client, UMockdevIoctlData* argument);
  int release(UMockdevIoctlClient* client, UMockdevIoctlData* argument);
  int submit(UrbQueue& urbs, UMockdevIoctlData* argument);
  int reap(UrbQueue& urbs, UMockdevIoctlData* argument);
  std::optional<std::vector<std::uint8_t>> next_report(Interface& interface);
  Interface* interface_at(unsigned number);

  EmulatedBus& bus_;
  EmulatedSpaceMouseSettings settings_{};
  UMockdevIoctlBase* ioctls_ = nullptr;
  std::string node_{};
  std::string system_path_{};
  int number_ = 1;

  mutable std::mutex mutex_{};
  bool plugged_ = false;
  int opened_ = 0;
  int failing_transfers_ = 0;
  std::vector<Interface> interfaces_{};
  std::map<const UMockdevIoctlClient*, UrbQueue> urbs_{};  // of each open file of its node
  IoctlAnswers answers_{[this](const auto*, auto* client) { answer_ioctl(client); }};
};

}  // namespace asperity
