// What a device that keeps time itself calls in tests: one reading and one push for each call.

#pragma once

#include <atomic>
#include <mutex>
#include <optional>
#include <thread>

#include "device/haptic_device.h"

namespace asperity {

struct ReadAndPush {
  HapticDevice* device = nullptr;  ///< told to stop at the end; null after it is gone
  Wrench wanted{};
  std::mutex mutex{};
  std::optional<ProbeState> last{};
  std::atomic<int> ticks{0};
  std::atomic<int> unread{0};   ///< ticks in which the device did not answer
  std::atomic<int> refused{0};  ///< in which it did not take the push
  std::int64_t now_ns = 0;

  ~ReadAndPush() {
    if (device != nullptr) device->stop_calls();
  }
  void start(double rate_Hz = 1000.0) {
    device->start_calls({.function = &ReadAndPush::tick, .argument = this, .rate_Hz = rate_Hz});
  }
  static void tick(void* self) noexcept { static_cast<ReadAndPush*>(self)->run(); }
  void run() noexcept {
    now_ns += 1'000'000;
    const std::optional<ProbeState> probe = device->read(now_ns);
    if (!probe) ++unread;
    if (!device->push(wanted, 1e-3)) ++refused;
    {
      const std::lock_guard lock(mutex);
      last = probe;
    }
    ++ticks;
  }
  void wait_for(int more) const {
    const int until = ticks + more;
    while (ticks < until) std::this_thread::yield();
  }
  ProbeState probe() {
    const std::lock_guard lock(mutex);
    return last.value();
  }
};

}  // namespace asperity
