// USB without hardware: what the kernel answers to libusb.

#include "tests/device/emulated_usb.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <stdexcept>
#include <utility>
#include <vector>

#include <linux/usbdevice_fs.h>
#include <umockdev.h>

namespace asperity {
namespace {

constexpr int kTaken = -ENOENT;

std::string three_digits(int number) {
  char three[8]{};
  std::snprintf(three, sizeof three, "%03d", number);
  return three;
}

}  // namespace

EmulatedBus::EmulatedBus() : testbed_(umockdev_testbed_new()) {
  add("", 1, hex_of({0x12, 1, 0,    2, 9, 0, 0, 64,   0x6b, 0x1d, 2, 0, 0, 6, 0, 0, 0, 1,  //
                     9,    2, 25,   0, 1, 1, 0, 0xe0, 0,                                   //
                     9,    4, 0,    0, 1, 9, 0, 0,    0,                                   //
                     7,    5, 0x81, 3, 4, 0, 12}));
}

EmulatedBus::~EmulatedBus() { g_object_unref(testbed_); }

bool EmulatedBus::is_possible() {
  const char* preloaded = std::getenv("LD_PRELOAD");
  return preloaded != nullptr && std::strstr(preloaded, "umockdev") != nullptr;
}

std::filesystem::path EmulatedBus::folder() const {
  gchar* root = umockdev_testbed_get_root_dir(testbed_);
  const std::filesystem::path folder = root;
  g_free(root);
  return folder;
}

std::string EmulatedBus::node_of(int number) { return "/dev/bus/usb/001/" + three_digits(number); }

std::string EmulatedBus::add(const std::string& port, int number, const std::string& descriptors) {
  const std::string name = port.empty() ? "usb1" : "usb1/" + port;
  const std::string node = node_of(number);
  const std::string entry =
      "P: /devices/" + name + "\nN: " + node.substr(5) +
      "\nE: SUBSYSTEM=usb\nE: DRIVER=usb\nE: DEVTYPE=usb_device\nE: BUSNUM=001\nE: DEVNUM=" +
      three_digits(number) + "\nE: DEVNAME=" + node +
      "\nA: bConfigurationValue=1\\n\nA: busnum=1\\n\nA: devnum=" + std::to_string(number) +
      "\\n\nA: speed=12\\n\nH: descriptors=" + descriptors + "\n\n";
  GError* error = nullptr;
  if (umockdev_testbed_add_from_string(testbed_, entry.c_str(), &error) == FALSE) {
    const std::string message = error->message;
    g_error_free(error);
    throw std::runtime_error(message);
  }
  const std::string system_path = "/sys/devices/" + name;
  if (!port.empty()) umockdev_testbed_uevent(testbed_, system_path.c_str(), "add");
  return system_path;
}

void EmulatedBus::remove(const std::string& system_path) {
  umockdev_testbed_uevent(testbed_, system_path.c_str(), "remove");
  umockdev_testbed_remove_device(testbed_, system_path.c_str());
}

void EmulatedBus::forbid(const std::string& node) {
  using std::filesystem::perms;
  std::filesystem::permissions(folder(), perms::all);
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder())) {
    if (entry.is_directory()) std::filesystem::permissions(entry, perms::all);
  }
  // umockdev connects to some other end of a node before it looks whether the node was opened at all.
  std::filesystem::permissions(folder() / "ioctl/_default", perms::all);
  std::filesystem::permissions(folder() / node.substr(1), perms::none);
}

IoctlAnswers::IoctlAnswers(Answer answer) { line_->answer = std::move(answer); }

IoctlAnswers::~IoctlAnswers() {
  const std::lock_guard lock(line_->mutex);
  line_->answer = {};
}

void IoctlAnswers::connect(UMockdevIoctlBase* plug) {
  g_signal_connect_data(
      plug, "handle-ioctl", G_CALLBACK(&IoctlAnswers::on_ioctl), new std::shared_ptr(line_),
      [](void* line, GClosure*) { delete static_cast<std::shared_ptr<Line>*>(line); },
      GConnectFlags{});
}

int IoctlAnswers::on_ioctl(UMockdevIoctlBase* plug, UMockdevIoctlClient* client, void* line) {
  const std::shared_ptr<Line> held = *static_cast<std::shared_ptr<Line>*>(line);
  const std::lock_guard lock(held->mutex);
  if (held->answer) {
    held->answer(plug, client);
  } else {
    umockdev_ioctl_client_complete(client, -1, ENODEV);
  }
  return TRUE;
}

std::string hex_of(std::initializer_list<int> bytes) {
  std::string text;
  for (const int byte : bytes) {
    char two[3]{};
    std::snprintf(two, sizeof two, "%02x", static_cast<unsigned>(byte) & 0xffU);
    text += two;
  }
  return text;
}

std::optional<int> answer_text_request(std::uint8_t* setup_and_data, int length,
                                       const std::string& text) {
  constexpr std::uint8_t kFromDevice = 0x80;
  constexpr std::uint8_t kGetDescriptor = 6;
  constexpr std::uint8_t kText = 3;
  if (setup_and_data[0] != kFromDevice || setup_and_data[1] != kGetDescriptor ||
      setup_and_data[3] != kText) {
    return std::nullopt;
  }
  // Languages, or UTF-16, with a head.
  std::vector<std::uint8_t> answer{0, kText};
  if (setup_and_data[2] == 0) {
    answer.insert(answer.end(), {0x09, 0x04});
  } else {
    for (const char letter : text) {
      answer.insert(answer.end(), {static_cast<std::uint8_t>(letter), 0});
    }
  }
  answer[0] = static_cast<std::uint8_t>(answer.size());
  const auto fits = std::min(answer.size(), static_cast<std::size_t>(length - 8));
  std::copy_n(answer.begin(), fits, setup_and_data + 8);
  return static_cast<int>(fits);
}

usbdevfs_urb& Urb::urb() const { return *reinterpret_cast<usbdevfs_urb*>(data->data); }

std::uint8_t* Urb::bytes() const { return buffer->data; }

std::optional<Urb> UrbQueue::submitted(UMockdevIoctlData* argument) {
  const auto shared = [](UMockdevIoctlData* data) {
    return data == nullptr ? nullptr
                           : std::shared_ptr<UMockdevIoctlData>(data, umockdev_ioctl_data_unref);
  };
  Urb one{.submitted = std::chrono::steady_clock::now()};
  one.data = shared(umockdev_ioctl_data_resolve(argument, 0, sizeof(usbdevfs_urb), nullptr));
  if (!one.data) return std::nullopt;
  usbdevfs_urb& urb = one.urb();
  one.buffer = shared(umockdev_ioctl_data_resolve(one.data.get(), offsetof(usbdevfs_urb, buffer),
                                                  static_cast<gsize>(urb.buffer_length), nullptr));
  if (!one.buffer) return std::nullopt;
  urb.status = 0;
  return one;
}

void UrbQueue::finish(Urb urb, int status, int length) {
  urb.urb().status = status;
  urb.urb().actual_length = length;
  finished_.push_back(std::move(urb));
}

void UrbQueue::finish_waiting(std::size_t which, int length) {
  const auto place = waiting_.begin() + static_cast<std::ptrdiff_t>(which);
  Urb urb = std::move(*place);
  waiting_.erase(place);
  finish(std::move(urb), 0, length);
}

void UrbQueue::end_waiting(int status) {
  for (Urb& one : waiting_) finish(std::move(one), status, 0);
  waiting_.clear();
}

void UrbQueue::take_finished(UrbQueue& other) {
  std::move(other.finished_.begin(), other.finished_.end(), std::back_inserter(finished_));
  other.finished_.clear();
}

bool UrbQueue::reap(UMockdevIoctlData* argument) {
  if (finished_.empty()) return false;
  const Urb one = std::move(finished_.front());
  finished_.pop_front();
  UMockdevIoctlData* pointer = umockdev_ioctl_data_resolve(argument, 0, sizeof(void*), nullptr);
  if (pointer == nullptr) return true;  // whoever asked is dead
  umockdev_ioctl_data_set_ptr(pointer, 0, one.data.get());
  umockdev_ioctl_data_unref(pointer);
  return true;
}

int UrbQueue::discard(UMockdevIoctlData* argument) {
  const unsigned long address = *reinterpret_cast<unsigned long*>(argument->data);
  const auto found = std::find_if(waiting_.begin(), waiting_.end(),
                                  [&](const Urb& one) { return one.data->client_addr == address; });
  if (found == waiting_.end()) return EINVAL;
  Urb urb = std::move(*found);
  waiting_.erase(found);
  finish(std::move(urb), kTaken, 0);
  return 0;
}

void UrbQueue::clear() {
  waiting_.clear();
  finished_.clear();
}

}  // namespace asperity
