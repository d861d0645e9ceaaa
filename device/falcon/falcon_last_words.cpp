// Zero for a Falcon's motors when the program that drove it is dead or stands still.

#include "device/falcon/falcon_last_words.h"

#include <cerrno>
#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <linux/usbdevice_fs.h>
#include <time.h>

#include "device/falcon/falcon_port.h"
#include "device/monotonic_clock.h"

namespace asperity::falcon {
namespace {

constexpr unsigned kPatience_ms = 20;
constexpr std::int64_t kLongestOfTheDead_ns = 60'000'000'000;
constexpr std::int64_t kLongestWaitedFor_ns = 1'000'000'000;
constexpr timespec kBetweenTries{0, 5'000'000};

}  // namespace

bool send_zero(int file, const Frame& zero) noexcept {
  Frame frame = zero;  // the kernel's struct is not const; it does not write to what goes out
  usbdevfs_bulktransfer transfer{.ep = kOutEndpoint,
                                 .len = static_cast<unsigned>(frame.size()),
                                 .timeout = kPatience_ms,
                                 .data = frame.data()};
  return ioctl(file, USBDEVFS_BULK, &transfer) == static_cast<int>(frame.size());
}

void say_last_words(WatchdogProcess::Cause cause, const void* about) noexcept {
  const LastWords& words = *static_cast<const LastWords*>(about);
  if (cause == WatchdogProcess::Cause::stopped) {
    send_zero(words.file, words.zero);
    return;
  }
  // Shared with the dead, and so is its claim: both go with the last who has it open.
  close(words.file);
  const std::int64_t until_ns =
      monotonic_now_ns() +
      (cause == WatchdogProcess::Cause::ended ? kLongestOfTheDead_ns : kLongestWaitedFor_ns);
  do {
    const int file = open(words.node.data(), O_RDWR | O_CLOEXEC);
    if (file < 0 && (errno == ENOENT || errno == ENODEV || errno == ENXIO)) return;  // unplugged
    if (file >= 0) {
      unsigned interface = kInterface;
      const bool is_claimed = ioctl(file, USBDEVFS_CLAIMINTERFACE, &interface) == 0;
      const bool is_done = is_claimed && send_zero(file, words.zero);
      if (is_claimed) ioctl(file, USBDEVFS_RELEASEINTERFACE, &interface);
      close(file);
      if (is_done) return;
    }
    nanosleep(&kBetweenTries, nullptr);
  } while (monotonic_now_ns() < until_ns);
}

}  // namespace asperity::falcon
