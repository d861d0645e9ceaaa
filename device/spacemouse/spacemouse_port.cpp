// The wire to a SpaceMouse: HID over USB, through hidapi on libusb.

#include "device/spacemouse/spacemouse_port.h"

#include <algorithm>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <utility>

#include <hidapi.h>
#include <libusb.h>

#include "device/units_in_use.h"

namespace asperity::spacemouse {
namespace {

constexpr int kPatience_ms = 20;
constexpr int kSharedPatience_ms = 2;  // where another interface waits its turn

constexpr std::uint16_t kLogitech = 0x046d;
constexpr std::uint16_t k3Dconnexion = 0x256f;
constexpr std::array kModels{
    Model{{kLogitech, 0xc603}, "3Dconnexion SpaceMouse Plus XT"},
    Model{{kLogitech, 0xc605}, "3Dconnexion CADman"},
    Model{{kLogitech, 0xc606}, "3Dconnexion SpaceMouse Classic"},
    Model{{kLogitech, 0xc621}, "3Dconnexion Spaceball 5000"},
    Model{{kLogitech, 0xc623}, "3Dconnexion SpaceTraveler"},
    Model{{kLogitech, 0xc625}, "3Dconnexion SpacePilot"},
    Model{{kLogitech, 0xc626}, "3Dconnexion SpaceNavigator"},
    Model{{kLogitech, 0xc627}, "3Dconnexion SpaceExplorer"},
    Model{{kLogitech, 0xc628}, "3Dconnexion SpaceNavigator for Notebooks"},
    Model{{kLogitech, 0xc629}, "3Dconnexion SpacePilot Pro"},
    Model{{kLogitech, 0xc62b}, "3Dconnexion SpaceMouse Pro"},
    Model{{k3Dconnexion, 0xc62e}, "3Dconnexion SpaceMouse Wireless"},
    Model{{k3Dconnexion, 0xc62f}, "3Dconnexion SpaceMouse Wireless receiver"},
    Model{{k3Dconnexion, 0xc631}, "3Dconnexion SpaceMouse Pro Wireless"},
    Model{{k3Dconnexion, 0xc632}, "3Dconnexion SpaceMouse Pro Wireless receiver"},
    Model{{k3Dconnexion, 0xc633}, "3Dconnexion SpaceMouse Enterprise"},
    Model{{k3Dconnexion, 0xc635}, "3Dconnexion SpaceMouse Compact"},
    Model{{k3Dconnexion, 0xc636}, "3Dconnexion SpaceMouse Module"},
    Model{{k3Dconnexion, 0xc638}, "3Dconnexion SpaceMouse Pro Wireless"},
    Model{{k3Dconnexion, 0xc63a}, "3Dconnexion SpaceMouse Wireless"},
    Model{{k3Dconnexion, 0xc641}, "3Dconnexion SpaceMouse Module"},
    Model{{k3Dconnexion, 0xc652}, "3Dconnexion Universal Receiver", 2},
};

const Model* model_of(const UsbProduct& one) noexcept {
  const auto found = std::find_if(kModels.begin(), kModels.end(), [&one](const Model& model) {
    return model.usb.vendor == one.vendor && model.usb.product == one.product;
  });
  return found == kModels.end() ? nullptr : &*found;
}

bool is_spacemouse(const UsbProduct& one) { return model_of(one) != nullptr; }

// Where a device may tell of its cap.
struct CapInterfaces {
  int configuration = 0;
  std::vector<int> numbers{};
};

CapInterfaces cap_interfaces(libusb_device* device) {
  CapInterfaces interfaces{};
  libusb_config_descriptor* configuration = nullptr;
  if (libusb_get_active_config_descriptor(device, &configuration) != LIBUSB_SUCCESS) {
    return interfaces;
  }
  interfaces.configuration = configuration->bConfigurationValue;
  const int most = model_of(usb_product(device))->interfaces;
  for (int i = 0; i < configuration->bNumInterfaces; ++i) {
    const libusb_interface& one = configuration->interface[i];
    // Protocols 1 and 2 are the keyboards and mice that a computer starts with: a receiver's, of other devices.
    if (one.num_altsetting > 0 && one.altsetting[0].bInterfaceClass == LIBUSB_CLASS_HID &&
        one.altsetting[0].bInterfaceProtocol == 0 &&
        static_cast<int>(interfaces.numbers.size()) < most) {
      interfaces.numbers.push_back(one.altsetting[0].bInterfaceNumber);
    }
  }
  libusb_free_config_descriptor(configuration);
  return interfaces;
}

// What keeps an interface from being taken; the kernel's own driver does not.
int error_of_taking(libusb_device_handle* handle, int interface) {
  if (libusb_kernel_driver_active(handle, interface) == 1) return LIBUSB_SUCCESS;
  const int error = libusb_claim_interface(handle, interface);
  if (error == LIBUSB_SUCCESS) libusb_release_interface(handle, interface);
  return error;
}

AttachedDevice looked_at(libusb_device* device) {
  AttachedDevice one{.model = model_of(usb_product(device))->name,
                     .place = usb_place(device),
                     .remark = "It has no motors: it moves the probe, and no force is felt."};
  const CapInterfaces interfaces = cap_interfaces(device);
  libusb_device_handle* handle = nullptr;
  int error = libusb_open(device, &handle);
  if (error == LIBUSB_SUCCESS) {
    one.serial = usb_serial(handle);
    error = interfaces.numbers.empty() ? LIBUSB_ERROR_NOT_FOUND : LIBUSB_SUCCESS;
    for (const int interface : interfaces.numbers) {
      if (error == LIBUSB_SUCCESS) error = error_of_taking(handle, interface);
    }
    libusb_close(handle);
  }
  if (error != LIBUSB_SUCCESS) one.blocker = usb_blocker(error, one.model, one.place);
  return one;
}

}  // namespace

// hidapi is one for the process: begun with the first port that is open and ended with the last.
class SpaceMousePort::Hidapi final {
 public:
  Hidapi() {
    const std::lock_guard lock(mutex());
    if (ports() == 0 && hid_init() != 0) {
      throw std::runtime_error(
          "USB devices cannot be opened: hidapi cannot be initialised; check its installation");
    }
    ++ports();
  }
  ~Hidapi() {
    const std::lock_guard lock(mutex());
    if (--ports() == 0) hid_exit();
  }
  Hidapi(const Hidapi&) = delete;
  Hidapi& operator=(const Hidapi&) = delete;

 private:
  static std::mutex& mutex() {
    static std::mutex one;
    return one;
  }
  static int& ports() {
    static int count = 0;
    return count;
  }
};

std::span<const Model> models() noexcept { return kModels; }

std::vector<AttachedDevice> attached_spacemice(const UsbSession& usb) {
  std::vector<AttachedDevice> attached = UnitInUse::of(kSpaceMouse);
  const std::vector<AttachedDevice> ours = attached;
  const UsbDevices found(usb, is_spacemouse);
  for (libusb_device* device : found.devices()) {
    const bool is_ours = std::any_of(
        ours.begin(), ours.end(),
        [place = usb_place(device)](const AttachedDevice& used) { return used.place == place; });
    if (!is_ours) attached.push_back(looked_at(device));
  }
  std::sort(attached.begin(), attached.end(),
            [](const auto& one, const auto& other) { return one.place < other.place; });
  return attached;
}

SpaceMousePort::SpaceMousePort(const UsbSession& usb, const std::string& place) {
  const UsbDevices found(usb, is_spacemouse);
  const auto device =
      std::find_if(found.devices().begin(), found.devices().end(),
                   [&place](libusb_device* one) { return usb_place(one) == place; });
  if (device == found.devices().end()) {
    throw std::runtime_error(usb_blocker(LIBUSB_ERROR_NO_DEVICE, "SpaceMouse", place));
  }
  // hidapi gives no reasons.
  const AttachedDevice look = looked_at(*device);
  if (!look.is_usable()) throw std::runtime_error(look.blocker);
  hidapi_ = std::make_unique<Hidapi>();
  const CapInterfaces interfaces = cap_interfaces(*device);
  for (const int interface : interfaces.numbers) {
    // As hidapi calls it: "1-2.3:1.0".
    const std::string path = place.substr(place.find(' ') + 1) + ':' +
                             std::to_string(interfaces.configuration) + '.' +
                             std::to_string(interface);
    if (hid_device* one = hid_open_path(path.c_str())) interfaces_.push_back(one);
  }
  if (interfaces_.empty() || interfaces_.size() < interfaces.numbers.size()) {
    close();
    throw std::runtime_error(usb_blocker(LIBUSB_ERROR_IO, look.model, place));
  }
}

SpaceMousePort::~SpaceMousePort() { close(); }

void SpaceMousePort::close() noexcept {
  for (hid_device* one : interfaces_) hid_close(one);
  interfaces_.clear();
}

SpaceMousePort::Read SpaceMousePort::read(Report& report, std::size_t& count) noexcept {
  const int patience_ms = interfaces_.size() == 1 ? kPatience_ms : kSharedPatience_ms;
  next_ = (next_ + 1) % interfaces_.size();
  const int length =
      hid_read_timeout(interfaces_[next_], report.data(), report.size(), patience_ms);
  count = static_cast<std::size_t>(std::max(0, length));
  return length < 0 ? Read::gone : length == 0 ? Read::nothing : Read::report;
}

}  // namespace asperity::spacemouse
