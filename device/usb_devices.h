// USB devices through libusb: which are attached, where, and what keeps one from being opened.

#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "device/drivers.h"

struct libusb_context;
struct libusb_device;
struct libusb_device_handle;

namespace asperity {

/// One use of libusb. Errors: std::runtime_error when the machine has no USB at all.
class UsbSession final {
 public:
  UsbSession();
  ~UsbSession();
  UsbSession(const UsbSession&) = delete;
  UsbSession& operator=(const UsbSession&) = delete;

  libusb_context* context() const noexcept { return context_; }

 private:
  libusb_context* context_ = nullptr;
};

/// A kind of device, which every device reports without being opened.
struct UsbProduct {
  std::uint16_t vendor = 0;
  std::uint16_t product = 0;
};

/// The attached devices whose kind `fits`, none of them opened; they are released at the end.
class UsbDevices final {
 public:
  UsbDevices(const UsbSession& usb, const std::function<bool(const UsbProduct&)>& fits);
  ~UsbDevices();
  UsbDevices(const UsbDevices&) = delete;
  UsbDevices& operator=(const UsbDevices&) = delete;

  const std::vector<libusb_device*>& devices() const noexcept { return devices_; }

 private:
  libusb_device** list_ = nullptr;
  std::vector<libusb_device*> devices_{};
};

UsbProduct usb_product(libusb_device* device);
/// "usb 1-2.3": bus and ports, as the kernel names them.
std::string usb_place(libusb_device* device);
/// The serial number that an open device reports, or nothing. Takes 0.4 s at the worst.
std::string usb_serial(libusb_device_handle* handle);
/// Why `product` at `place` cannot be opened, in a sentence; `error` is libusb's.
std::string usb_blocker(int error, const std::string& product, const std::string& place);

/// A unit that was opened and is gone, and is to be found again.
struct LostUnit {
  std::string place{};
  std::string serial{};
  bool was_alone = false;  ///< no other of its kind was attached when it was opened
};

/// The unit that is back and can be opened: the one of the same serial number; without one, what is plugged in where
/// it was. Another place only where there cannot be a second one: where one alone was attached when it was
/// opened, and is now. Null when there is none.
const AttachedDevice* found_again(const LostUnit& unit,
                                  const std::vector<AttachedDevice>& attached);

}  // namespace asperity
