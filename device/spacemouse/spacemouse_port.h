// The wire to a SpaceMouse: HID over USB, through hidapi on libusb.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "device/drivers.h"
#include "device/usb_devices.h"

struct hid_device_;

namespace asperity::spacemouse {

/// The driver's name.
inline constexpr const char* kSpaceMouse = "spacemouse";

/// One model, or one receiver of wireless ones.
struct Model {
  UsbProduct usb{};
  const char* name = "";
  /// How many of its first HID interfaces may tell of the cap. The universal receiver tells of a SpaceMouse Pro
  /// Wireless on one and of a SpaceMouse Wireless on the next.
  int interfaces = 1;
};

/// All that this driver opens. Mice and keyboards have the numbers of the same makers.
std::span<const Model> models() noexcept;

/// Those on the bus: model, serial number, place, and what keeps one from being opened. What this program has open
/// (UnitInUse) is listed and not touched; what is open elsewhere is left alone.
std::vector<AttachedDevice> attached_spacemice(const UsbSession& usb);

/// Reports from one SpaceMouse. Its interfaces are taken from the kernel's driver and given back at the end.
///
/// Errors: the constructor throws std::runtime_error with a sentence.
///
/// Threads: one at a time for each port; hidapi has one of its own for each interface.
class SpaceMousePort final {
 public:
  /// Opens the one at `place` ("usb 1-2").
  SpaceMousePort(const UsbSession& usb, const std::string& place);
  ~SpaceMousePort();
  SpaceMousePort(const SpaceMousePort&) = delete;
  SpaceMousePort& operator=(const SpaceMousePort&) = delete;

  using Report = std::array<std::uint8_t, 64>;
  enum class Read { report, nothing, gone };
  /// Waits for a report for 20 ms at most: `report` gets its `count` bytes, its number first.
  Read read(Report& report, std::size_t& count) noexcept;

 private:
  class Hidapi;
  void close() noexcept;
  std::unique_ptr<Hidapi> hidapi_;
  std::vector<hid_device_*> interfaces_{};
  std::size_t next_ = 0;  // the interface to be asked
};

}  // namespace asperity::spacemouse
