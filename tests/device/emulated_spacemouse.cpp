// SpaceMice without hardware: what the kernel and the device answer to a driver.

#include "tests/device/emulated_spacemouse.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <sys/ioctl.h>
#include <thread>
#include <utility>

#include <linux/usbdevice_fs.h>
#include <umockdev.h>

namespace asperity {
namespace {

constexpr auto kBetweenReports = std::chrono::milliseconds(8);

// What an ioctl's argument points to.
template <typename Struct>
class Pointed final {
 public:
  explicit Pointed(UMockdevIoctlData* argument)
      : data_(umockdev_ioctl_data_resolve(argument, 0, sizeof(Struct), nullptr)) {}
  ~Pointed() {
    if (data_ != nullptr) umockdev_ioctl_data_unref(data_);
  }
  Pointed(const Pointed&) = delete;
  Pointed& operator=(const Pointed&) = delete;
  Struct* get() const {
    return data_ == nullptr ? nullptr : reinterpret_cast<Struct*>(data_->data);
  }

 private:
  UMockdevIoctlData* data_ = nullptr;
};

}  // namespace

std::vector<std::uint8_t> report_of(std::uint8_t number, const std::vector<int>& deflections) {
  std::vector<std::uint8_t> report{number};
  for (const int deflection : deflections) {
    report.push_back(static_cast<std::uint8_t>(deflection & 0xff));
    report.push_back(static_cast<std::uint8_t>((deflection >> 8) & 0xff));
  }
  return report;
}

EmulatedSpaceMouse::EmulatedSpaceMouse(EmulatedBus& bus, EmulatedSpaceMouseSettings settings)
    : bus_(bus), settings_(std::move(settings)) {
  number_ = 10 * settings_.port;
  ioctls_ = umockdev_ioctl_base_new();
  answers_.connect(ioctls_);
  plug_in();
}

EmulatedSpaceMouse::~EmulatedSpaceMouse() {
  if (plugged_) unplug();
  umockdev_testbed_detach_ioctl(bus_.testbed(), node_.c_str(), nullptr);
  g_object_unref(ioctls_);
}

void EmulatedSpaceMouse::plug_in() {
  const int count = static_cast<int>(settings_.protocols.size());
  {
    const std::lock_guard lock(mutex_);
    plugged_ = true;
    interfaces_.assign(settings_.protocols.size(), {});
    if (!node_.empty()) umockdev_testbed_detach_ioctl(bus_.testbed(), node_.c_str(), nullptr);
    node_ = EmulatedBus::node_of(++number_);
  }
  umockdev_testbed_attach_ioctl(bus_.testbed(), node_.c_str(), ioctls_, nullptr);
  const int serial = settings_.serial.empty() ? 0 : 3;
  constexpr int kInterface_bytes = 9 + 9 + 7;
  std::string descriptors = hex_of({0x12,
                                    1,
                                    0,
                                    2,
                                    0,
                                    0,
                                    0,
                                    32,
                                    settings_.vendor,
                                    settings_.vendor >> 8,
                                    settings_.product,
                                    settings_.product >> 8,
                                    0,
                                    4,
                                    0,
                                    0,
                                    serial,
                                    1,  //
                                    9,
                                    2,
                                    9 + count * kInterface_bytes,
                                    0,
                                    count,
                                    1,
                                    0,
                                    0x80,
                                    50});
  for (int i = 0; i < count; ++i) {
    const int protocol = settings_.protocols[static_cast<std::size_t>(i)];
    descriptors += hex_of({9,        4,    i,        0, 1,  3, protocol == 0 ? 0 : 1,
                           protocol, 0,  //
                           9,        0x21, 0x11,     1, 0,  1, 0x22,
                           217,      0,  //
                           7,        5,    0x81 + i, 3, 32, 0, 8});
  }
  system_path_ = bus_.add("1-" + std::to_string(settings_.port), number_, descriptors);
}

void EmulatedSpaceMouse::unplug() {
  {
    const std::lock_guard lock(mutex_);
    plugged_ = false;
    interfaces_.assign(settings_.protocols.size(), {});
  }
  bus_.remove(system_path_);
}

void EmulatedSpaceMouse::forbid() {
  umockdev_testbed_detach_ioctl(bus_.testbed(), node_.c_str(), nullptr);
  bus_.forbid(node_);
}

void EmulatedSpaceMouse::say(std::vector<std::uint8_t> report, std::size_t interface) {
  const std::lock_guard lock(mutex_);
  interfaces_.at(interface).to_say.push_back(std::move(report));
}

void EmulatedSpaceMouse::hold(std::vector<std::vector<std::uint8_t>> reports,
                              std::size_t interface) {
  const std::lock_guard lock(mutex_);
  interfaces_.at(interface).held = std::move(reports);
  interfaces_.at(interface).next_held = 0;
}

void EmulatedSpaceMouse::fail_transfers(int count) {
  const std::lock_guard lock(mutex_);
  failing_transfers_ = count;
}

bool EmulatedSpaceMouse::is_held(std::size_t interface) const {
  const std::lock_guard lock(mutex_);
  return interfaces_.at(interface).holder != nullptr;
}

bool EmulatedSpaceMouse::is_the_kernels(std::size_t interface) const {
  const std::lock_guard lock(mutex_);
  return interfaces_.at(interface).is_the_kernels;
}

bool EmulatedSpaceMouse::has_said_all() const {
  const std::lock_guard lock(mutex_);
  return std::all_of(interfaces_.begin(), interfaces_.end(),
                     [](const Interface& one) { return one.to_say.empty(); });
}

int EmulatedSpaceMouse::opened() const {
  const std::lock_guard lock(mutex_);
  return opened_;
}

void EmulatedSpaceMouse::answer_ioctl(UMockdevIoctlClient* client) {
  UMockdevIoctlData* argument = umockdev_ioctl_client_get_arg(client);
  const auto answered = [&] {
    const std::lock_guard lock(mutex_);
    switch (umockdev_ioctl_client_get_request(client)) {
      case USBDEVFS_GET_CAPABILITIES: {
        ++opened_;
        const Pointed<std::uint32_t> answer(argument);
        if (answer.get() != nullptr) {
          *answer.get() = USBDEVFS_CAP_BULK_CONTINUATION | USBDEVFS_CAP_NO_PACKET_SIZE_LIM |
                          USBDEVFS_CAP_BULK_SCATTER_GATHER | USBDEVFS_CAP_REAP_AFTER_DISCONNECT;
        }
        return 0;
      }
      case USBDEVFS_GETDRIVER:
        return driver_of(argument);
      case USBDEVFS_IOCTL:
        return connect_or_disconnect(argument);
      case USBDEVFS_CLAIMINTERFACE:
        return claim(client, argument);
      case USBDEVFS_RELEASEINTERFACE:
        return release(client, argument);
      case USBDEVFS_SUBMITURB:
        return submit(urbs_[client], argument);
      case USBDEVFS_REAPURB:
      case USBDEVFS_REAPURBNDELAY:
        return reap(urbs_[client], argument);
      case USBDEVFS_DISCARDURB:
        return urbs_[client].discard(argument);
      case USBDEVFS_CLEAR_HALT:
      case USBDEVFS_RESETEP:
        return 0;
      default:
        return ENOTTY;
    }
  };
  const int error = answered();
  // The node is no device, so that the driver's poll never sleeps: let it sleep here.
  if (error == EAGAIN) std::this_thread::sleep_for(std::chrono::microseconds(200));
  umockdev_ioctl_client_complete(client, error == 0 ? 0 : -1, error);
}

EmulatedSpaceMouse::Interface* EmulatedSpaceMouse::interface_at(unsigned number) {
  return number < interfaces_.size() ? &interfaces_[number] : nullptr;
}

int EmulatedSpaceMouse::driver_of(UMockdevIoctlData* argument) {
  const Pointed<usbdevfs_getdriver> asked(argument);
  if (asked.get() == nullptr || !plugged_) return ENODEV;
  const Interface* one = interface_at(asked.get()->interface);
  if (one == nullptr) return EINVAL;
  if (one->holder == nullptr && !one->is_the_kernels) return ENODATA;
  std::strcpy(asked.get()->driver, one->holder != nullptr ? "usbfs" : "usbhid");
  return 0;
}

int EmulatedSpaceMouse::connect_or_disconnect(UMockdevIoctlData* argument) {
  const Pointed<usbdevfs_ioctl> asked(argument);
  if (asked.get() == nullptr || !plugged_) return ENODEV;
  Interface* one = interface_at(static_cast<unsigned>(asked.get()->ifno));
  if (one == nullptr) return EINVAL;
  const bool connects = static_cast<unsigned>(asked.get()->ioctl_code) == USBDEVFS_CONNECT;
  if (one->is_the_kernels == connects) return connects ? EBUSY : ENODATA;
  if (one->holder != nullptr) return EBUSY;
  one->is_the_kernels = connects;
  return 0;
}

int EmulatedSpaceMouse::claim(UMockdevIoctlClient* client, UMockdevIoctlData* argument) {
  const Pointed<unsigned> number(argument);
  if (number.get() == nullptr || !plugged_) return ENODEV;
  Interface* one = interface_at(*number.get());
  if (one == nullptr) return EINVAL;
  if (one->holder != nullptr || one->is_the_kernels) return EBUSY;
  one->holder = client;
  return 0;
}

int EmulatedSpaceMouse::release(UMockdevIoctlClient* client, UMockdevIoctlData* argument) {
  const Pointed<unsigned> number(argument);
  if (number.get() == nullptr || !plugged_) return ENODEV;
  Interface* one = interface_at(*number.get());
  if (one == nullptr || one->holder != client) return EINVAL;
  one->holder = nullptr;
  return 0;
}

int EmulatedSpaceMouse::submit(UrbQueue& urbs, UMockdevIoctlData* argument) {
  if (!plugged_) return ENODEV;
  std::optional<Urb> one = UrbQueue::submitted(argument);
  if (!one) return ENODEV;
  if (one->urb().type == USBDEVFS_URB_TYPE_CONTROL) {
    const auto told = answer_text_request(one->bytes(), one->urb().buffer_length, settings_.serial);
    urbs.finish(*std::move(one), told ? 0 : -EPIPE, told.value_or(0));
  } else if (failing_transfers_ > 0) {
    --failing_transfers_;
    urbs.finish(*std::move(one), kBusError, 0);
  } else {
    urbs.wait(*std::move(one));
  }
  return 0;
}

int EmulatedSpaceMouse::reap(UrbQueue& urbs, UMockdevIoctlData* argument) {
  if (!plugged_) urbs.end_waiting(kUnplugged);
  for (std::size_t i = 0; i < urbs.waiting().size() && !urbs.has_finished(); ++i) {
    const Urb& waiting = urbs.waiting()[i];
    Interface* one = interface_at((waiting.urb().endpoint & 0x0fU) - 1U);
    if (one == nullptr) continue;
    if (const auto report = next_report(*one)) {
      const auto room = static_cast<std::size_t>(waiting.urb().buffer_length);
      const std::size_t count = std::min(report->size(), room);
      std::copy_n(report->begin(), count, waiting.bytes());
      urbs.finish_waiting(i, static_cast<int>(count));
    }
  }
  if (urbs.reap(argument)) return 0;
  return plugged_ ? EAGAIN : ENODEV;
}

std::optional<std::vector<std::uint8_t>> EmulatedSpaceMouse::next_report(Interface& interface) {
  if (!interface.to_say.empty()) {
    std::vector<std::uint8_t> report = std::move(interface.to_say.front());
    interface.to_say.pop_front();
    return report;
  }
  const auto now = std::chrono::steady_clock::now();
  if (interface.held.empty() || now - interface.said < kBetweenReports) return std::nullopt;
  interface.said = now;
  return interface.held[interface.next_held++ % interface.held.size()];
}

}  // namespace asperity
