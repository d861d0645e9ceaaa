// The wire to a Falcon: the serial chip that it has on USB.

#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "device/drivers.h"
#include "device/falcon/falcon_last_words.h"
#include "device/usb_devices.h"

namespace asperity::falcon {

inline constexpr int kInterface = 0;
inline constexpr unsigned char kOutEndpoint = 0x02;
inline constexpr unsigned char kInEndpoint = 0x81;

/// The Falcons on the bus: serial number and place, and what keeps one from being opened (a permission,
/// a program that holds it). What is open elsewhere is left alone.
std::vector<AttachedDevice> attached_falcons(const UsbSession& usb);

/// How a transfer ended.
enum class Transfer {
  done,
  timed_out,
  failed,  ///< the bus or the device had an error; the next may succeed
  gone,    ///< the device is unplugged
};

/// Bytes to and from one Falcon. Each packet that comes begins with two bytes about the serial chip's
/// modem lines, which are taken away here.
///
/// Errors: the constructor throws std::runtime_error with a sentence.
///
/// One port at a time for each session of libusb.
///
/// Threads: one at a time. No call takes longer than the time it is given, and a control transfer no
/// longer than 0.2 s.
class FalconPort final {
 public:
  /// Opens and claims the one at `place` ("usb 1-2"). `usb` outlives the port.
  FalconPort(const UsbSession& usb, const std::string& place);
  ~FalconPort();
  FalconPort(const FalconPort&) = delete;
  FalconPort& operator=(const FalconPort&) = delete;

  static constexpr std::size_t kPacket_bytes = 64;
  using Packet = std::array<std::uint8_t, kPacket_bytes>;

  Transfer write(std::span<const std::uint8_t> bytes, std::chrono::milliseconds patience) noexcept;
  /// One packet: `packet` gets its bytes, `count` of them, 0 when the device had nothing to say.
  Transfer read(Packet& packet, std::size_t& count, std::chrono::milliseconds patience) noexcept;

  /// The chip's settings for frames, 1.5 Mbaud; nothing of before is left in its buffers.
  Transfer begin_frames() noexcept;
  /// 9600 baud, and a pulse on the line that restarts the boot loader.
  Transfer begin_boot_loader() noexcept;
  /// 140 kbaud, at which the boot loader takes firmware.
  Transfer begin_firmware() noexcept;

  /// For who has to speak to it when this process cannot.
  LastWords last_words() const noexcept;

 private:
  enum class Request : std::uint8_t;
  Transfer control(Request request, std::uint16_t value) noexcept;
  Transfer control_all(std::span<const std::pair<Request, std::uint16_t>> steps) noexcept;

  libusb_context* context_ = nullptr;
  libusb_device_handle* handle_ = nullptr;
};

}  // namespace asperity::falcon
