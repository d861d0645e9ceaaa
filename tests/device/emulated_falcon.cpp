// Falcons without hardware: what the kernel and the device answer to a driver.

#include "tests/device/emulated_falcon.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <sys/ioctl.h>
#include <thread>

#include <linux/usbdevice_fs.h>
#include <umockdev.h>

#include "tests/device/falcon_arm_angles.h"

namespace asperity {
namespace {

using std::chrono::steady_clock;

constexpr auto kLatency = std::chrono::milliseconds(4);
constexpr std::size_t kPacket_bytes = 64;
constexpr std::array<std::uint8_t, 3> kCall{0x0a, 0x43, 0x0d};

}  // namespace

EmulatedFalcon::EmulatedFalcon(EmulatedBus& bus, EmulatedFalconSettings settings)
    : bus_(bus), settings_(std::move(settings)) {
  runs_ = settings_.runs_firmware;
  homed_ = settings_.is_homed;
  number_ = 10 * settings_.port;
  put_grip(centre_m_);
  plug_in();
}

EmulatedFalcon::~EmulatedFalcon() {
  if (plugged_) unplug();
  umockdev_testbed_detach_ioctl(bus_.testbed(), node_.c_str(), nullptr);
  for (UMockdevIoctlBase* plug : plugs_) g_object_unref(plug);
}

void EmulatedFalcon::plug_in() {
  UMockdevIoctlBase* plug = umockdev_ioctl_base_new();
  ioctls_.connect(plug);
  {
    const std::lock_guard lock(mutex_);
    plugged_ = true;
    held_ = false;
    received_.clear();
    to_say_.clear();
    answers_.clear();
    strongest_ = 0;
    if (!node_.empty()) umockdev_testbed_detach_ioctl(bus_.testbed(), node_.c_str(), nullptr);
    node_ = EmulatedBus::node_of(++number_);
    plugs_.push_back(plug);
  }
  umockdev_testbed_attach_ioctl(bus_.testbed(), node_.c_str(), plug, nullptr);
  const int serial = settings_.serial.empty() ? 0 : 3;
  const std::string descriptors = hex_of({0x12, 1,    0x10, 1, 0,  0,    0,    8,      0x03,
                                          0x04, 0x48, 0xcb, 0, 4,  0,    0,    serial, 1,   //
                                          9,    2,    32,   0, 1,  1,    0,    0x80,   45,  //
                                          9,    4,    0,    0, 2,  0xff, 0xff, 0xff,   0,   //
                                          7,    5,    0x81, 2, 64, 0,    0,                 //
                                          7,    5,    0x02, 2, 64, 0,    0});
  system_path_ = bus_.add("1-" + std::to_string(settings_.port), number_, descriptors);
}

void EmulatedFalcon::unplug() {
  {
    const std::lock_guard lock(mutex_);
    plugged_ = false;
    held_ = false;
    urbs_.end_waiting(kUnplugged);
    former_urbs_.take_finished(urbs_);
  }
  bus_.remove(system_path_);
}

void EmulatedFalcon::forbid() {
  umockdev_testbed_detach_ioctl(bus_.testbed(), node_.c_str(), nullptr);
  bus_.forbid(node_);
}

void EmulatedFalcon::lose_power() {
  const std::lock_guard lock(mutex_);
  runs_ = false;
  homed_ = false;
  loading_ = false;
}

void EmulatedFalcon::put_grip(const glm::dvec3& position_m) {
  const std::lock_guard lock(mutex_);
  centre_m_ = position_m;
  counts_ = falcon::counts_at(position_m);
}

void EmulatedFalcon::circle(double radius_m) {
  const std::lock_guard lock(mutex_);
  circle_m_ = radius_m;
}

void EmulatedFalcon::press(std::uint8_t buttons) {
  const std::lock_guard lock(mutex_);
  buttons_ = buttons;
}

void EmulatedFalcon::home() {
  const std::lock_guard lock(mutex_);
  homed_ = true;
}

void EmulatedFalcon::fail_transfers(int count) {
  const std::lock_guard lock(mutex_);
  failing_transfers_ = count;
}

void EmulatedFalcon::take_no_frames(bool takes_none) {
  const std::lock_guard lock(mutex_);
  takes_none_ = takes_none;
}

void EmulatedFalcon::fall_silent(bool silent) {
  const std::lock_guard lock(mutex_);
  silent_ = silent;
}

void EmulatedFalcon::spoil_loads(int count) {
  const std::lock_guard lock(mutex_);
  spoilt_loads_ = count;
}

void EmulatedFalcon::answer_late(std::chrono::milliseconds delay) {
  const std::lock_guard lock(mutex_);
  delay_ = delay;
}

void EmulatedFalcon::let_go() {
  const std::lock_guard lock(mutex_);
  held_ = false;
  urbs_.clear();
}

int EmulatedFalcon::take_most_unread() {
  const std::lock_guard lock(mutex_);
  return std::exchange(most_unread_, 0);
}

void EmulatedFalcon::flip(const std::array<std::int16_t, 3>& bits) {
  const std::lock_guard lock(mutex_);
  flipped_ = bits;
}

void EmulatedFalcon::babble(std::vector<std::uint8_t> noise) {
  const std::lock_guard lock(mutex_);
  noise_ = std::move(noise);
}

bool EmulatedFalcon::runs_firmware() const {
  const std::lock_guard lock(mutex_);
  return runs_;
}

bool EmulatedFalcon::is_held() const {
  const std::lock_guard lock(mutex_);
  return held_;
}

int EmulatedFalcon::refused_claims() const {
  const std::lock_guard lock(mutex_);
  return refused_claims_;
}

std::int64_t EmulatedFalcon::frames() const {
  const std::lock_guard lock(mutex_);
  return frames_;
}

int EmulatedFalcon::loads() const {
  const std::lock_guard lock(mutex_);
  return loads_;
}

falcon::Frame EmulatedFalcon::last_frame() const {
  const std::lock_guard lock(mutex_);
  return last_frame_;
}

std::array<std::int16_t, 3> EmulatedFalcon::motor_words() const {
  return falcon::answer_in(last_frame())->counts;
}

int EmulatedFalcon::take_strongest_word() {
  const std::lock_guard lock(mutex_);
  return std::exchange(strongest_, 0);
}

std::vector<std::pair<int, int>> EmulatedFalcon::settings_sent() const {
  const std::lock_guard lock(mutex_);
  return settings_sent_;
}

void EmulatedFalcon::answer_ioctl(const UMockdevIoctlBase* plug, UMockdevIoctlClient* client) {
  const unsigned long request = umockdev_ioctl_client_get_request(client);
  const int error = [&] {
    const std::lock_guard lock(mutex_);
    return plugged_ && plug == plugs_.back() ? serve(client) : serve_former(client);
  }();
  // The node is no device, so that the driver's poll never sleeps: let it sleep here.
  if (error == EAGAIN) std::this_thread::sleep_for(std::chrono::microseconds(100));
  // The kernel tells how many bytes it sent.
  const long done = request == USBDEVFS_BULK ? static_cast<long>(falcon::kFrame_bytes) : 0;
  umockdev_ioctl_client_complete(client, error == 0 ? done : -1, error);
}

// Transfers that were under way end; all else finds no device.
int EmulatedFalcon::serve_former(UMockdevIoctlClient* client) {
  switch (umockdev_ioctl_client_get_request(client)) {
    case USBDEVFS_REAPURB:
    case USBDEVFS_REAPURBNDELAY:
      return former_urbs_.reap(umockdev_ioctl_client_get_arg(client)) ? 0 : ENODEV;
    default:
      return ENODEV;
  }
}

int EmulatedFalcon::serve(UMockdevIoctlClient* client) {
  UMockdevIoctlData* argument = umockdev_ioctl_client_get_arg(client);
  switch (umockdev_ioctl_client_get_request(client)) {
    case USBDEVFS_GET_CAPABILITIES: {
      UMockdevIoctlData* answer =
          umockdev_ioctl_data_resolve(argument, 0, sizeof(std::uint32_t), nullptr);
      if (answer == nullptr) return 0;  // the process that asked is dead
      const std::uint32_t capabilities =
          USBDEVFS_CAP_BULK_CONTINUATION | USBDEVFS_CAP_NO_PACKET_SIZE_LIM |
          USBDEVFS_CAP_BULK_SCATTER_GATHER | USBDEVFS_CAP_REAP_AFTER_DISCONNECT;
      std::memcpy(answer->data, &capabilities, sizeof capabilities);
      umockdev_ioctl_data_unref(answer);
      return 0;
    }
    case USBDEVFS_CLAIMINTERFACE:
      if (held_) {
        ++refused_claims_;
        return EBUSY;
      }
      held_ = true;
      holder_ = client;
      return 0;
    case USBDEVFS_RELEASEINTERFACE:
      if (holder_ == client) held_ = false;
      return 0;
    case USBDEVFS_BULK:
      return held_ && holder_ == client ? send_at_once(argument) : EBUSY;
    case USBDEVFS_SUBMITURB:
      return submit(argument);
    case USBDEVFS_REAPURB:
    case USBDEVFS_REAPURBNDELAY:
      return reap(argument);
    case USBDEVFS_DISCARDURB:
      return urbs_.discard(argument);
    case USBDEVFS_CLEAR_HALT:
    case USBDEVFS_RESETEP:
      return 0;
    default:
      return ENOTTY;
  }
}

int EmulatedFalcon::submit(UMockdevIoctlData* argument) {
  std::optional<Urb> one = UrbQueue::submitted(argument);
  if (!one) return ENODEV;
  const usbdevfs_urb& urb = one->urb();
  const int length = urb.buffer_length;
  if (urb.type == USBDEVFS_URB_TYPE_CONTROL) {
    const int answered = control(one->bytes(), length);
    urbs_.finish(*std::move(one), 0, answered);
  } else if (failing_transfers_ > 0) {
    --failing_transfers_;
    urbs_.finish(*std::move(one), kBusError, 0);
  } else if ((urb.endpoint & 0x80U) == 0 && !takes_none_) {
    for (int i = 0; i < length; ++i) take_byte(one->bytes()[i]);
    urbs_.finish(*std::move(one), 0, length);
  } else {
    urbs_.wait(*std::move(one));
  }
  return 0;
}

int EmulatedFalcon::reap(UMockdevIoctlData* argument) {
  if (!urbs_.has_finished() && !urbs_.waiting().empty()) {
    if (const std::optional<int> count = fill(urbs_.waiting().front())) {
      urbs_.finish_waiting(0, *count);
    }
  }
  return urbs_.reap(argument) ? 0 : EAGAIN;
}

// One transfer out, for a process that has no libusb any more.
int EmulatedFalcon::send_at_once(UMockdevIoctlData* argument) {
  UMockdevIoctlData* data =
      umockdev_ioctl_data_resolve(argument, 0, sizeof(usbdevfs_bulktransfer), nullptr);
  if (data == nullptr) return ENODEV;
  const auto& transfer = *reinterpret_cast<const usbdevfs_bulktransfer*>(data->data);
  int error = transfer.len == falcon::kFrame_bytes && transfer.ep == 0x02 ? 0 : EINVAL;
  if (error == 0) {
    UMockdevIoctlData* bytes = umockdev_ioctl_data_resolve(
        data, offsetof(usbdevfs_bulktransfer, data), falcon::kFrame_bytes, nullptr);
    if (bytes != nullptr) {
      for (std::size_t i = 0; i < falcon::kFrame_bytes; ++i) take_byte(bytes->data[i]);
      umockdev_ioctl_data_unref(bytes);
    } else {
      error = ENODEV;
    }
  }
  umockdev_ioctl_data_unref(data);
  return error;
}

// What the device has to say by now, after its two bytes.
std::optional<int> EmulatedFalcon::fill(const Urb& one) {
  if ((one.urb().endpoint & 0x80U) == 0) return {};  // it goes out, and waits
  const auto now = steady_clock::now();
  if (to_say_.empty() && !answers_.empty() && now >= answers_.front().due) {
    to_say_.assign(answers_.front().bytes.begin(), answers_.front().bytes.end());
    answers_.pop_front();
  }
  const bool speaks = !to_say_.empty();
  if (!speaks && now - one.submitted < kLatency) return std::nullopt;
  const std::size_t room =
      std::min(static_cast<std::size_t>(one.urb().buffer_length), kPacket_bytes);
  std::size_t count = 0;
  one.bytes()[count++] = 0x01;
  one.bytes()[count++] = 0x60;
  while (speaks && count < room && !to_say_.empty()) {
    one.bytes()[count++] = to_say_.front();
    to_say_.pop_front();
  }
  return static_cast<int>(count);
}

int EmulatedFalcon::control(std::uint8_t* setup_and_data, int length) {
  const int kind = setup_and_data[0];
  const int request = setup_and_data[1];
  const int value = setup_and_data[2] | setup_and_data[3] << 8;
  if (const auto told = answer_text_request(setup_and_data, length, settings_.serial)) return *told;
  if (kind != 0x40) return 0;
  if (setup_and_data[4] != 0 || setup_and_data[5] != 0) return 0;  // of another port of a chip
  settings_sent_.emplace_back(request, value);
  switch (request) {
    case 0:
      if (value == 1) {
        to_say_.clear();
        while (!answers_.empty() && answers_.front().due <= steady_clock::now()) {
          answers_.pop_front();
        }
      }
      if (value == 2) received_.clear();
      break;
    case 1:
      if (value == 0x0101) {
        line_ready_ = true;
        loading_ = false;  // it starts again
      }
      if (value == 0x0100) line_ready_ = false;
      break;
    case 3:
      divisor_ = value;
      // The end of a load: what came runs, or nothing does.
      if (value == 0x0002 && loading_) {
        loading_ = false;
        runs_ = taken_ == settings_.firmware;
      }
      break;
    default:
      break;
  }
  return 0;
}

void EmulatedFalcon::take_byte(std::uint8_t byte) {
  if (silent_) return;
  const auto answer = [this](std::initializer_list<std::uint8_t> bytes) {
    to_say_.insert(to_say_.end(), bytes);
  };
  if (!runs_ && divisor_ == 0x4138 && line_ready_) {
    received_.push_back(byte);
    if (received_.size() >= kCall.size() &&
        std::equal(kCall.begin(), kCall.end(), received_.end() - 3)) {
      received_.clear();
      answer({0x0a, 0x44, 0x2c, 0x0d});
    }
  } else if (!runs_ && divisor_ == 0x0015) {
    if (!loading_) {
      if (byte != 0x41) return;
      loading_ = true;
      ++loads_;
      taken_.clear();
      answer({0x41});
      return;
    }
    taken_.push_back(byte);
    const bool spoils = spoilt_loads_ > 0 && taken_.size() == 100;
    if (spoils) --spoilt_loads_;
    answer({static_cast<std::uint8_t>(spoils ? byte ^ 0x10U : byte)});
  } else if (runs_ && divisor_ == 0x0002) {
    if (byte == '<') received_.clear();
    received_.push_back(byte);
    if (received_.size() == falcon::kFrame_bytes && byte == '>') {
      falcon::Frame frame{};
      std::copy(received_.begin(), received_.end(), frame.begin());
      received_.clear();
      take_frame(frame);
    }
  }
}

void EmulatedFalcon::take_frame(const falcon::Frame& frame) {
  last_frame_ = frame;
  ++frames_;
  // The way out has the shape of the way in.
  const falcon::Answer words = falcon::answer_in(frame).value();
  for (const std::int16_t word : words.counts) {
    strongest_ = std::max(strongest_, std::abs(int{word}));
  }
  std::array<std::int16_t, 3> counts = counts_now();
  for (std::size_t i = 0; i < 3; ++i)
    counts[i] = static_cast<std::int16_t>(counts[i] ^ flipped_[i]);
  falcon::Frame bytes = falcon::frame_of({.motor_words = counts});
  bytes[13] = static_cast<std::uint8_t>('A' + buttons_ + (homed_ ? 0x70 : 0));
  most_unread_ =
      std::max(most_unread_, static_cast<int>(answers_.size()) + (to_say_.empty() ? 0 : 1));
  const auto period = std::chrono::duration_cast<steady_clock::duration>(
      std::chrono::duration<double>(1.0 / settings_.rate_Hz));
  last_due_ = std::max(steady_clock::now(), last_due_ + period) + std::exchange(delay_, {});
  Spoken spoken{.due = last_due_, .bytes = noise_};
  spoken.bytes.insert(spoken.bytes.end(), bytes.begin(), bytes.end());
  answers_.push_back(std::move(spoken));
}

std::array<std::int16_t, 3> EmulatedFalcon::counts_now() const {
  if (circle_m_ == 0.0) return counts_;
  const double turn = 2.0 * std::numbers::pi *
                      std::chrono::duration<double>(steady_clock::now().time_since_epoch()).count();
  return falcon::counts_at(centre_m_ + circle_m_ * glm::dvec3(std::cos(turn), std::sin(turn), 0.0));
}

}  // namespace asperity
