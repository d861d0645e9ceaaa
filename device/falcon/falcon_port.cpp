// The wire to a Falcon: the serial chip that it has on USB, through libusb.

#include "device/falcon/falcon_port.h"

#include <algorithm>
#include <cstdio>
#include <stdexcept>
#include <utility>

#include <libusb.h>
#include <poll.h>

namespace asperity::falcon {

// What the serial chip understands.
enum class FalconPort::Request : std::uint8_t {
  reset = 0,
  modem_lines = 1,
  flow_control = 2,
  baud_divisor = 3,
  data_format = 4,
  latency_ms = 9,
};

namespace {

constexpr std::uint16_t kVendor = 0x0403;
constexpr std::uint16_t kProduct = 0xcb48;
constexpr std::size_t kModem_bytes = 2;
constexpr std::uint8_t kToChip = 0x40;
constexpr unsigned kControl_ms = 200;

constexpr std::uint16_t kForgetReceived = 1;
constexpr std::uint16_t kForgetToSend = 2;
constexpr std::uint16_t kDtrLow = 0x0100;
constexpr std::uint16_t kDtrHigh = 0x0101;
constexpr std::uint16_t kRtsLow = 0x0200;
constexpr std::uint16_t k9600Baud = 0x4138;
constexpr std::uint16_t k140kBaud = 0x0015;
constexpr std::uint16_t k1500kBaud = 0x0002;
constexpr std::uint16_t kEightBitsNoParityOneStop = 8;

constexpr const char* kProductName = "Novint Falcon";

bool is_falcon(const UsbProduct& one) { return one.vendor == kVendor && one.product == kProduct; }

Transfer outcome_of(int error) noexcept {
  switch (error) {
    case LIBUSB_SUCCESS:
      return Transfer::done;
    case LIBUSB_ERROR_TIMEOUT:
      return Transfer::timed_out;
    case LIBUSB_ERROR_NO_DEVICE:
      return Transfer::gone;
    default:
      return Transfer::failed;
  }
}

}  // namespace

std::vector<AttachedDevice> attached_falcons(const UsbSession& usb) {
  std::vector<AttachedDevice> attached;
  const UsbDevices found(usb, is_falcon);
  for (libusb_device* device : found.devices()) {
    AttachedDevice one{.model = kProductName, .place = usb_place(device)};
    libusb_device_handle* handle = nullptr;
    int error = libusb_open(device, &handle);
    if (error == LIBUSB_SUCCESS) {
      one.serial = usb_serial(handle);
      error = libusb_claim_interface(handle, kInterface);
      if (error == LIBUSB_SUCCESS) libusb_release_interface(handle, kInterface);
      libusb_close(handle);
    }
    if (error != LIBUSB_SUCCESS) one.blocker = usb_blocker(error, kProductName, one.place);
    attached.push_back(std::move(one));
  }
  std::sort(attached.begin(), attached.end(),
            [](const auto& one, const auto& other) { return one.place < other.place; });
  return attached;
}

FalconPort::FalconPort(const UsbSession& usb, const std::string& place) : context_(usb.context()) {
  const UsbDevices found(usb, is_falcon);
  int error = LIBUSB_ERROR_NO_DEVICE;
  for (libusb_device* device : found.devices()) {
    if (usb_place(device) != place) continue;
    error = libusb_open(device, &handle_);
    if (error != LIBUSB_SUCCESS) break;
    error = libusb_claim_interface(handle_, kInterface);
    if (error != LIBUSB_SUCCESS) libusb_close(handle_);
    break;
  }
  if (error != LIBUSB_SUCCESS) {
    throw std::runtime_error(usb_blocker(error, kProductName, place));
  }
}

FalconPort::~FalconPort() {
  libusb_release_interface(handle_, kInterface);
  libusb_close(handle_);
}

Transfer FalconPort::write(std::span<const std::uint8_t> bytes,
                           std::chrono::milliseconds patience) noexcept {
  int written = 0;
  // libusb's parameter is not const; it does not write to what goes out.
  const int error = libusb_bulk_transfer(
      handle_, kOutEndpoint, const_cast<unsigned char*>(bytes.data()),
      static_cast<int>(bytes.size()), &written, static_cast<unsigned>(patience.count()));
  if (error == LIBUSB_ERROR_PIPE) libusb_clear_halt(handle_, kOutEndpoint);
  if (error == LIBUSB_SUCCESS && written != static_cast<int>(bytes.size())) return Transfer::failed;
  return outcome_of(error);
}

Transfer FalconPort::read(Packet& packet, std::size_t& count,
                          std::chrono::milliseconds patience) noexcept {
  count = 0;
  Packet received{};
  int length = 0;
  const int error =
      libusb_bulk_transfer(handle_, kInEndpoint, received.data(), static_cast<int>(received.size()),
                           &length, static_cast<unsigned>(patience.count()));
  if (error == LIBUSB_ERROR_PIPE) libusb_clear_halt(handle_, kInEndpoint);
  const auto bytes = static_cast<std::size_t>(std::max(0, length));
  if (bytes > kModem_bytes) {
    count = bytes - kModem_bytes;
    std::copy_n(received.begin() + kModem_bytes, count, packet.begin());
    if (error == LIBUSB_ERROR_TIMEOUT) return Transfer::done;  // it came at the last moment
  }
  return outcome_of(error);
}

Transfer FalconPort::control(Request request, std::uint16_t value) noexcept {
  const int result = libusb_control_transfer(handle_, kToChip, static_cast<std::uint8_t>(request),
                                             value, 0, nullptr, 0, kControl_ms);
  return outcome_of(std::min(result, 0));
}

Transfer FalconPort::control_all(
    std::span<const std::pair<Request, std::uint16_t>> steps) noexcept {
  for (const auto& [request, value] : steps) {
    if (const Transfer ended = control(request, value); ended != Transfer::done) return ended;
  }
  return Transfer::done;
}

Transfer FalconPort::begin_frames() noexcept {
  constexpr std::array<std::pair<Request, std::uint16_t>, 4> kSteps{{
      {Request::latency_ms, std::uint16_t{1}},
      {Request::baud_divisor, k1500kBaud},
      {Request::reset, kForgetReceived},
      {Request::reset, kForgetToSend},
  }};
  return control_all(kSteps);
}

LastWords FalconPort::last_words() const noexcept {
  LastWords words{};
  libusb_device* device = libusb_get_device(handle_);
  std::snprintf(words.node.data(), words.node.size(), "/dev/bus/usb/%03d/%03d",
                int{libusb_get_bus_number(device)}, int{libusb_get_device_address(device)});
  // libusb waits for an open device to be ready for writing, and for nothing else that way.
  if (const libusb_pollfd** files = libusb_get_pollfds(context_); files != nullptr) {
    for (const libusb_pollfd** file = files; *file != nullptr; ++file) {
      if (((*file)->events & POLLOUT) != 0) words.file = (*file)->fd;
    }
    libusb_free_pollfds(files);
  }
  return words;
}

Transfer FalconPort::begin_boot_loader() noexcept {
  constexpr std::array<std::pair<Request, std::uint16_t>, 9> kSteps{{
      {Request::reset, kForgetReceived},
      {Request::reset, kForgetToSend},
      {Request::latency_ms, std::uint16_t{16}},
      {Request::baud_divisor, k9600Baud},
      {Request::data_format, kEightBitsNoParityOneStop},
      {Request::flow_control, std::uint16_t{0}},
      {Request::modem_lines, kRtsLow},
      {Request::modem_lines, kDtrLow},
      {Request::modem_lines, kDtrHigh},
  }};
  return control_all(kSteps);
}

Transfer FalconPort::begin_firmware() noexcept {
  constexpr std::array<std::pair<Request, std::uint16_t>, 2> kSteps{{
      {Request::modem_lines, kDtrLow},
      {Request::baud_divisor, k140kBaud},
  }};
  return control_all(kSteps);
}

}  // namespace asperity::falcon
