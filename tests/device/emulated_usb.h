// USB without hardware: a machine's bus, and transfers as the kernel keeps them.

#pragma once

#include <cerrno>
#include <chrono>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "device/haptic_device.h"
#include "tests/support/patience.h"

typedef struct _UMockdevTestbed UMockdevTestbed;
typedef struct _UMockdevIoctlBase UMockdevIoctlBase;
typedef struct _UMockdevIoctlClient UMockdevIoctlClient;
typedef struct _UMockdevIoctlData UMockdevIoctlData;

struct usbdevfs_urb;

namespace asperity {

/// How a transfer ended, as the kernel numbers it.
inline constexpr int kBusError = -EPROTO;
inline constexpr int kUnplugged = -ESHUTDOWN;

/// A machine whose only USB devices are emulated: what the process opens of /sys and /dev/bus/usb lies in
/// a folder of its own. The program has to run under umockdev-wrapper.
class EmulatedBus final {
 public:
  EmulatedBus();
  ~EmulatedBus();
  EmulatedBus(const EmulatedBus&) = delete;
  EmulatedBus& operator=(const EmulatedBus&) = delete;

  /// The program was started so that this can work.
  static bool is_possible();

  UMockdevTestbed* testbed() const noexcept { return testbed_; }
  std::filesystem::path folder() const;

  /// The kernel's node of a device with this number on the bus.
  static std::string node_of(int number);
  /// A device at `port`, "1-2", as sysfs and the kernel tell of it; returns where sysfs has it.
  std::string add(const std::string& port, int number, const std::string& descriptors);
  void remove(const std::string& system_path);
  /// Nobody may open this node any more; a thread has to be without root's rights to find out. Nothing may be attached
  /// to the node.
  void forbid(const std::string& node);

 private:
  UMockdevTestbed* testbed_ = nullptr;
};

/// What a device answers to the kernel's calls, in umockdev's thread: a call may come while or after the device is
/// destroyed, of a process that has not closed its file yet.
class IoctlAnswers final {
 public:
  using Answer = std::function<void(const UMockdevIoctlBase* plug, UMockdevIoctlClient* client)>;
  explicit IoctlAnswers(Answer answer);
  /// Waits for the answer that is on its way; from then on there is no such device.
  ~IoctlAnswers();
  IoctlAnswers(const IoctlAnswers&) = delete;
  IoctlAnswers& operator=(const IoctlAnswers&) = delete;

  void connect(UMockdevIoctlBase* plug);

 private:
  struct Line {
    std::mutex mutex{};
    Answer answer{};
  };
  static int on_ioctl(UMockdevIoctlBase* plug, UMockdevIoctlClient* client, void* line);

  std::shared_ptr<Line> line_ = std::make_shared<Line>();
};

/// Bytes as sysfs entries spell them.
std::string hex_of(std::initializer_list<int> bytes);

/// What a device answers to a request for one of its texts: the languages for number 0, or `text`. Writes to
/// `setup_and_data`, whose first eight bytes are the request; returns how many bytes it wrote, nothing where something
/// else is asked for.
std::optional<int> answer_text_request(std::uint8_t* setup_and_data, int length,
                                       const std::string& text);

/// A transfer on its way.
struct Urb {
  std::shared_ptr<UMockdevIoctlData> data{};    // the kernel's struct, which the driver has too
  std::shared_ptr<UMockdevIoctlData> buffer{};  // what it points to
  std::chrono::steady_clock::time_point submitted{};

  usbdevfs_urb& urb() const;
  std::uint8_t* bytes() const;
};

/// The transfers of one device: those that wait for it to say something, and those that the driver has not fetched.
class UrbQueue final {
 public:
  /// What the driver submits; nothing when whoever submits is dead.
  static std::optional<Urb> submitted(UMockdevIoctlData* argument);

  void wait(Urb urb) { waiting_.push_back(std::move(urb)); }
  void finish(Urb urb, int status, int length);
  std::deque<Urb>& waiting() noexcept { return waiting_; }
  /// The n-th that waits.
  void finish_waiting(std::size_t which, int length);
  bool has_finished() const noexcept { return !finished_.empty(); }
  /// All that wait end with `status`.
  void end_waiting(int status);
  /// Takes the finished ones of `other`, behind its own.
  void take_finished(UrbQueue& other);
  /// Hands the driver one that is finished; false where there is none.
  bool reap(UMockdevIoctlData* argument);
  /// The driver takes one back; the error number.
  int discard(UMockdevIoctlData* argument);
  void clear();

 private:
  std::deque<Urb> waiting_{};
  std::deque<Urb> finished_{};
};

/// Whether letting go of a device ends at all: a driver that hangs never does.
inline bool ends_soon(std::unique_ptr<HapticDevice> device) {
  const auto began = std::chrono::steady_clock::now();
  device.reset();
  return std::chrono::steady_clock::now() - began < kPatience;
}

}  // namespace asperity
