// Measures how long a tick that does not return exerts its force.

#include "app/timing/hung_ticks.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <thread>
#include <vector>

#include "device/monotonic_clock.h"
#include "renderers/servo/servo_thread.h"

namespace asperity {

namespace {

constexpr std::uint64_t kTicksBetween = 20;

struct Hanging {
  std::atomic<bool> is_wanted{false};
  std::atomic<std::int64_t> began_ns{0};
  std::atomic<std::int64_t> zeroed_ns{0};
};

class EndlessLoop final : public ForceRenderer {
 public:
  explicit EndlessLoop(Hanging& hanging) : hanging_(hanging) {}
  void reset(const ProbeState&) noexcept override {}
  RenderedTick tick(const ProbeState&, double) noexcept override {
    if (hanging_.is_wanted) hanging_.began_ns = monotonic_now_ns();
    while (hanging_.is_wanted) {
    }
    return {.wrench = {.force_N = {0.0, 0.0, 1.0}}};
  }

 private:
  Hanging& hanging_;
};

/// Notes when its force is zeroed from outside.
class ZeroedDevice final : public HapticDevice {
 public:
  explicit ZeroedDevice(Hanging& hanging)
      : HapticDevice({.name = "none", .peak_force_N = 10.0, .may_rest_exactly = true}, {}),
        hanging_(hanging) {}
  void zero_force_from_outside() noexcept override {
    std::int64_t none = 0;
    hanging_.zeroed_ns.compare_exchange_strong(none, monotonic_now_ns());
  }

 private:
  bool do_read(std::int64_t, ProbeState&) noexcept override { return true; }
  bool do_send(const Wrench&) noexcept override { return true; }

  Hanging& hanging_;
};

}  // namespace

TickTimes time_hung_ticks(const TickCount& count, unsigned busy_threads,
                          const std::stop_token& stop) {
  std::vector<std::jthread> busy{};
  for (unsigned i = 0; i < busy_threads; ++i) {
    busy.emplace_back([](const std::stop_token& ended) {
      while (!ended.stop_requested()) {
      }
    });
  }
  Hanging hanging{};
  ZeroedDevice device(hanging);
  RecordRing records{};
  // Of a busy computer, the other faults are not measured here.
  ServoLoop loop(device, records, {.heartbeat_timeout_s = 1e6, .misses_to_fault = 1'000'000});
  loop.present({.id = 1, .renderer = std::make_unique<EndlessLoop>(hanging)});
  const ServoThread thread(loop, device, Scheduling::fifo_if_permitted);
  const auto wait_until = [](const auto& condition) {
    while (!condition()) std::this_thread::sleep_for(std::chrono::microseconds(200));
  };

  TickTimes times{};
  const auto latest = std::chrono::steady_clock::now() + count.longest;
  while (times.undisturbed_ns.size() < static_cast<std::size_t>(count.counted) &&
         !stop.stop_requested() && std::chrono::steady_clock::now() < latest) {
    const std::uint64_t ticks = loop.status().ticks;
    wait_until([&] { return loop.status().ticks >= ticks + kTicksBetween; });
    loop.clear_fault(loop.status().fault);
    hanging.began_ns = 0;
    hanging.zeroed_ns = 0;
    hanging.is_wanted = true;
    wait_until([&] { return hanging.zeroed_ns != 0; });
    hanging.is_wanted = false;
    // A busy computer can have stopped the loop before the tick: that is not what is measured.
    if (hanging.began_ns == 0 || hanging.began_ns > hanging.zeroed_ns) {
      ++times.preempted;
    } else {
      times.undisturbed_ns.push_back(hanging.zeroed_ns - hanging.began_ns);
    }
  }
  std::sort(times.undisturbed_ns.begin(), times.undisturbed_ns.end());
  return times;
}

}  // namespace asperity
