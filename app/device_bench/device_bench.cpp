// Runs a device through short stages on the real servo loop, and hands back every tick.

#include "app/device_bench/device_bench.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <memory>
#include <thread>
#include <utility>

#include <glm/geometric.hpp>

#include "analysis/numbers/number_text.h"
#include "analysis/words/phrase.h"
#include "app/words/phrase_of_error.h"
#include "renderers/servo/servo_thread.h"
#include "renderers/servo/servo_time.h"

namespace asperity {
namespace {

constexpr double kConducted_s = 0.005;  // between two looks at a loop in real time
constexpr double kBenchRing_s = 8.0;
/// Until a tick under way counts as one that does not return; the servo thread and its watch wait as long for it.
constexpr double kHangs_s = 1.0;
constexpr double kFade_s = 0.060;  // a little longer than a surface takes to fade out

/// What the ticks of a stage and the bench both reach.
struct StageFlags {
  std::atomic<bool> ran_away{false};
  std::atomic<bool> is_over{false};  ///< what the stage's force refers to may be gone
};

/// The stage's force as a surface that is everywhere and never touched: it fades in at once.
class StageForce final : public ForceRenderer {
 public:
  StageForce(const DeviceStage& stage, StageFlags& flags)
      : force_N_(stage.force_N), reach_m_(stage.reach_m), flags_(flags) {}

  void reset(const ProbeState& first) noexcept override {
    first_ = first;
    let_go_ = false;
  }
  RenderedTick tick(const ProbeState& probe, double) noexcept override {
    let_go_ = let_go_ || glm::length(probe.position_m - first_.position_m) > reach_m_;
    RenderedTick tick{};
    if (flags_.is_over.load()) return tick;
    if (let_go_) {
      flags_.ran_away.store(true);
    } else {
      const double since_s = static_cast<double>(probe.time_ns - first_.time_ns) * 1e-9;
      tick.wrench.force_N = force_N_(since_s, probe);
    }
    return tick;
  }

 private:
  std::function<glm::dvec3(double, const ProbeState&)> force_N_{};
  double reach_m_ = 0.0;
  StageFlags& flags_;
  ProbeState first_{};
  bool let_go_ = false;
};

/// Why the device was lost, and what to do. Of one that keeps time itself and was lost in no tick, none came.
Phrase loss_of(const StageRecord& record, Pacing pacing) {
  if (!record.trouble.empty()) {
    return phrase("DeviceTest",
                  "the connection to the device was lost during the measurement: %1 Fix the "
                  "problem, then measure the device again.")
        .with(record.trouble);
  }
  const bool was_lost_in_a_tick =
      std::any_of(record.ticks.begin(), record.ticks.end(),
                  [](const TickRecord& tick) { return tick.has(TickFlag::device_lost); });
  if (pacing == Pacing::theirs && !was_lost_in_a_tick) {
    return phrase("DeviceTest",
                  "the connection to the device was lost during the measurement: the thread of the "
                  "manufacturer's driver made no call for %1 ms; it hangs or had to wait. Close "
                  "other programs that keep this computer busy, check the cable of the device, and "
                  "measure the device again.")
        .with(fixed(1e-6 * static_cast<double>(HapticDevice::kLongestSilence_ns), 0));
  }
  return phrase("DeviceTest",
                "the connection to the device was lost during the measurement: the device did not "
                "respond, and its driver reports no cause. Check its cable and its power supply, "
                "close other programs that keep this computer busy, and measure the device again.");
}

/// Which call does not return, and what to do.
Phrase hang_of(const TickProgress& progress, const DeviceCapability& device) {
  const Phrase call = progress.begun == progress.ended
                          ? phrase("DeviceTest", "setting the force to zero")
                      : progress.sending ? phrase("DeviceTest", "sending the force")
                                         : phrase("DeviceTest", "reading the position");
  return phrase("DeviceTest",
                "the device %1 does not respond: its driver has not returned from %2 for more than "
                "a second. Switch the device off, end this program, check the cables of the "
                "device, then measure it again.")
      .with(device.model + (device.serial.empty() ? "" : ' ' + device.serial), call);
}

}  // namespace

DeviceBench::DeviceBench(HapticDevice& device, double rate_Hz, std::stop_token stop,
                         WatchTicks watch)
    : device_(device), rate_Hz_(rate_Hz), stop_(std::move(stop)), watch_(std::move(watch)) {}

void DeviceBench::drain(RecordRing& ring, StageRecord& record) const {
  const std::size_t before = record.ticks.size();
  TickRecord tick{};
  while (ring.pop(tick)) record.ticks.push_back(tick);
  if (watch_ && record.ticks.size() > before) {
    watch_(std::span<const TickRecord>(record.ticks).subspan(before));
  }
}

/// Of a stage, kept by the servo thread where a call into the driver does not return.
struct DeviceBench::Driven {
  Driven(HapticDevice& device, std::size_t records, const ServoSettings& settings)
      : ring(records), loop(device, ring, settings) {}
  StageFlags flags{};
  RecordRing ring;
  ServoLoop loop;
};

StageRecord DeviceBench::run(const DeviceStage& stage, StagePacing pacing) {
  StageRecord record{};
  {
    ServoSettings settings = stage.servo;
    settings.rate_Hz = rate_Hz_;
    const auto driven = std::make_shared<Driven>(
        device_, static_cast<std::size_t>(kBenchRing_s * rate_Hz_), settings);
    if (stage.force_N) {
      driven->loop.present(
          {.id = 1, .renderer = std::make_unique<StageForce>(stage, driven->flags)});
    }
    if (pacing == StagePacing::real_time) {
      run_in_real_time(stage, driven, record);
    } else {
      run_stepped(stage, *driven, record);
    }
    record.fault = driven->loop.status().fault;
    record.ran_away = driven->flags.ran_away.load();
  }
  // First: of a device that is gone nobody can say that its force is zero.
  if (record.fault == Fault::device_lost) {
    if (record.trouble.empty()) record.trouble = device_.complaint();
    throw PhrasedError(loss_of(record, device_.capability().pacing));
  }
  if (stop_.stop_requested())
    throw DeviceStageStopped(
        "the test of the device was stopped on request, and the force is zero; to measure the "
        "device, begin the test again");
  const auto first = std::find_if(
      record.ticks.begin(), record.ticks.end(),
      [](const TickRecord& tick) { return tick.has(TickFlag::first_of_presentation); });
  const std::int64_t zero_ns = first != record.ticks.end() ? first->probe.time_ns
                               : record.ticks.empty()      ? 0
                                                           : record.ticks.front().probe.time_ns;
  record.time_s.reserve(record.ticks.size());
  for (const TickRecord& tick : record.ticks) {
    record.time_s.push_back(static_cast<double>(tick.probe.time_ns - zero_ns) * 1e-9);
  }
  return record;
}

void DeviceBench::run_in_real_time(const DeviceStage& stage, const std::shared_ptr<Driven>& driven,
                                   StageRecord& record) {
  {
    ServoThread thread(driven->loop, device_, Scheduling::fifo_if_permitted, driven);
    record.scheduling = thread.scheduling();
    conduct(stage, *driven, record);
  }
  if (driven.use_count() > 1) {  // a thread was left behind with it
    driven->flags.is_over.store(true);
    throw DriverHangs(hang_of(driven->loop.progress(), device_.capability()));
  }
}

void DeviceBench::conduct(const DeviceStage& stage, Driven& driven, StageRecord& record) {
  ServoLoop& loop = driven.loop;
  const std::int64_t began_ns = monotonic_now_ns();
  TickProgress last{};
  double last_came_s = 0.0;
  bool leaving = false;
  for (;;) {
    const double since_s = static_cast<double>(monotonic_now_ns() - began_ns) * 1e-9;
    const TickProgress now = loop.progress();
    if (!now.hangs_since(std::exchange(last, now))) last_came_s = since_s;
    if (since_s - last_came_s > kHangs_s) break;
    if (stop_.stop_requested()) loop.emergency_stop();
    if (!stage.falls_silent_at_s || since_s < *stage.falls_silent_at_s) loop.heartbeat();
    if (stage.conduct) stage.conduct(loop, since_s);
    drain(driven.ring, record);
    const Fault fault = loop.status().fault;
    // Now: it may be well again, and complain of nothing, before anybody asks.
    if (fault == Fault::device_lost) record.trouble = device_.complaint();
    if (stop_.stop_requested() || fault == Fault::device_lost) break;
    if (since_s >= stage.duration_s && !leaving) {
      loop.withdraw();
      leaving = true;
    }
    if (since_s >= stage.duration_s + kFade_s) break;
    std::this_thread::sleep_for(std::chrono::duration<double>(kConducted_s));
  }
  drain(driven.ring, record);
  now_ns_ = std::max(now_ns_, monotonic_now_ns());
}

void DeviceBench::run_stepped(const DeviceStage& stage, Driven& driven, StageRecord& record) {
  ServoLoop& loop = driven.loop;
  record.scheduling = "none";
  now_ns_ = std::max(now_ns_, monotonic_now_ns());
  const std::int64_t period_ns = period_ns_of(rate_Hz_);
  const auto ticks = static_cast<std::int64_t>(std::ceil((stage.duration_s + kFade_s) * rate_Hz_));
  for (std::int64_t tick = 0; tick < ticks && !stop_.stop_requested(); ++tick) {
    const double since_s = static_cast<double>(tick) / rate_Hz_;
    if (!stage.falls_silent_at_s || since_s < *stage.falls_silent_at_s) loop.heartbeat();
    if (stage.conduct) stage.conduct(loop, since_s);
    if (since_s >= stage.duration_s) loop.withdraw();
    now_ns_ += period_ns;
    loop.tick(now_ns_);
    drain(driven.ring, record);
  }
}

}  // namespace asperity
