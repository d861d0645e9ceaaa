// USB devices through libusb: which are attached, where, and what keeps one from being opened.

#include "device/usb_devices.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include <libusb.h>

namespace asperity {
namespace {

constexpr unsigned kTextPatience_ms = 200;

// libusb's own reader of texts waits for a second, twice.
std::vector<std::uint8_t> text_descriptor(libusb_device_handle* handle, std::uint8_t text,
                                          std::uint16_t language) {
  std::array<unsigned char, 255> bytes{};
  const int length = libusb_control_transfer(
      handle, LIBUSB_ENDPOINT_IN, LIBUSB_REQUEST_GET_DESCRIPTOR,
      static_cast<std::uint16_t>(LIBUSB_DT_STRING << 8U | text), language, bytes.data(),
      static_cast<std::uint16_t>(bytes.size()), kTextPatience_ms);
  const int told = std::min(length, int{bytes[0]});
  if (told < 2 || bytes[1] != LIBUSB_DT_STRING) return {};
  return {bytes.begin() + 2, bytes.begin() + told};
}

}  // namespace

UsbSession::UsbSession() {
  if (const int error = libusb_init(&context_); error != LIBUSB_SUCCESS) {
    throw std::runtime_error(
        std::string("USB devices cannot be listed: libusb cannot be initialised (") +
        libusb_strerror(error) + "); check its installation");
  }
}

UsbSession::~UsbSession() { libusb_exit(context_); }

UsbDevices::UsbDevices(const UsbSession& usb, const std::function<bool(const UsbProduct&)>& fits) {
  const ssize_t count = libusb_get_device_list(usb.context(), &list_);
  for (ssize_t i = 0; i < count; ++i) {
    if (fits(usb_product(list_[i]))) devices_.push_back(list_[i]);
  }
}

UsbDevices::~UsbDevices() {
  if (list_ != nullptr) libusb_free_device_list(list_, 1);
}

UsbProduct usb_product(libusb_device* device) {
  libusb_device_descriptor descriptor{};
  if (libusb_get_device_descriptor(device, &descriptor) != LIBUSB_SUCCESS) return {};
  return {.vendor = descriptor.idVendor, .product = descriptor.idProduct};
}

std::string usb_place(libusb_device* device) {
  std::array<std::uint8_t, 7> ports{};
  const int count = libusb_get_port_numbers(device, ports.data(), static_cast<int>(ports.size()));
  std::string place = "usb " + std::to_string(libusb_get_bus_number(device));
  for (int i = 0; i < count; ++i) {
    place += (i == 0 ? '-' : '.') + std::to_string(ports[static_cast<std::size_t>(i)]);
  }
  return place;
}

std::string usb_serial(libusb_device_handle* handle) {
  libusb_device_descriptor descriptor{};
  if (libusb_get_device_descriptor(libusb_get_device(handle), &descriptor) != LIBUSB_SUCCESS ||
      descriptor.iSerialNumber == 0) {
    return {};
  }
  const std::vector<std::uint8_t> languages = text_descriptor(handle, 0, 0);
  if (languages.size() < 2) return {};
  const auto language = static_cast<std::uint16_t>(languages[0] | languages[1] << 8U);
  const std::vector<std::uint8_t> utf16 =
      text_descriptor(handle, descriptor.iSerialNumber, language);
  std::string serial;
  for (std::size_t i = 0; i + 1 < utf16.size(); i += 2) {
    serial += utf16[i + 1] == 0 && utf16[i] < 0x80 ? static_cast<char>(utf16[i]) : '?';
  }
  return serial;
}

std::string usb_blocker(int error, const std::string& product, const std::string& place) {
  const std::string it = "the " + product + " at " + place;
  switch (error) {
    case LIBUSB_ERROR_ACCESS:
      return it +
             " may not be opened by this user: put Asperity's rule file 70-asperity.rules into "
             "/etc/udev/rules.d, then unplug the device and plug it in again (docs/devices.md "
             "states where the file is)";
    case LIBUSB_ERROR_BUSY:
      return it + " is used by another program or session; end that one first";
    case LIBUSB_ERROR_NO_DEVICE:
      return it + " was unplugged while it was being opened; plug it in again";
    default:
      return it + " cannot be opened (" + libusb_strerror(error) +
             "); unplug it and plug it in again";
  }
}

const AttachedDevice* found_again(const LostUnit& unit,
                                  const std::vector<AttachedDevice>& attached) {
  const AttachedDevice* same = nullptr;
  for (const AttachedDevice& one : attached) {
    const bool is_there = one.place == unit.place;
    const bool fits = unit.serial.empty() ? is_there || (unit.was_alone && attached.size() == 1)
                                          : one.serial == unit.serial;
    if (fits && one.is_usable() && (same == nullptr || is_there)) same = &one;
  }
  return same;
}

}  // namespace asperity
