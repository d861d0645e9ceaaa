// Steps the loop on a simulated clock, or runs it in a thread in real time and drains its ring in slices.

#include "app/session/rig/rig.h"

#include <chrono>
#include <cmath>
#include <thread>

#include "app/profiles/device_kind.h"
#include "app/session/rig/recorded_hand.h"
#include "app/session/rig/recorder.h"
#include "device/simulated_models.h"

namespace asperity {

namespace {

// Short enough that the ring never comes near its capacity and a stop takes effect at once.
constexpr double kRealTimeSlice_s = 0.005;
// The capacity of the ring: longer than a disk delays the conductor.
constexpr double kRing_s = 8.0;
constexpr std::int64_t kTicksBetweenDrains = 256;

/// The noise of the device's sensors differs between attempts, and is the same when an attempt is
/// replayed.
SimulatedDeviceSettings with_noise(SimulatedDeviceSettings settings, const Random& random) {
  settings.sensor.noise_seed = random.split("sensor").bits();
  return settings;
}

}  // namespace

RigSettings rig_settings_for(const Protocol& protocol, const std::vector<ScriptedFault>& faults,
                             const std::string& device) {
  RigSettings settings{};
  settings.device = simulated_settings(device).value_or(SimulatedDeviceSettings{});
  settings.servo.rate_Hz = protocol.rate_Hz;
  settings.limits.force_N = protocol.force_limit_N;
  settings.device.faults = faults;
  return settings;
}

struct SteppedRig::Assembly {
  Assembly(const RigSettings& settings, const HandHabits& habits, const Random& random)
      : hand(habits, random),
        device(hand, with_noise(settings.device, random)),
        loop(device, records, settings.servo) {
    device.set_limits(settings.limits);
  }
  VirtualHand hand;
  SimulatedDevice device;
  RecordRing records{2 * kTicksBetweenDrains};
  ServoLoop loop;
};

SteppedRig::SteppedRig(const RigSettings& settings, std::int64_t session_index)
    : settings_(settings), clock_(session_index) {
  prepare_attempt(HandHabits{}, Random(0));
}

SteppedRig::~SteppedRig() = default;

ServoLoop& SteppedRig::loop() noexcept { return assembly_->loop; }
RecordRing& SteppedRig::records() noexcept { return assembly_->records; }
VirtualHand& SteppedRig::hand() noexcept { return assembly_->hand; }
const DeviceCapability& SteppedRig::capability() const noexcept {
  return assembly_->device.capability();
}
const ForceLimits& SteppedRig::limits() const noexcept { return assembly_->device.limits(); }

void SteppedRig::prepare_attempt(const HandHabits& habits, const Random& random) {
  assembly_ = std::make_unique<Assembly>(settings_, habits, random);
  grid_origin_ns_ = clock_.now_ns();
  ticks_since_origin_ = 0;
  owed_s_ = 0.0;
}

void SteppedRig::clear_fault(Fault seen) noexcept {
  if (seen == Fault::emergency_stop) stop_wanted_.store(false);
  assembly_->loop.clear_fault(seen);
}

void SteppedRig::move_clock_to(std::int64_t now_ns) {
  clock_.move_to(now_ns);
  // The ticks before the next attempt (a screen, a break) count from here.
  grid_origin_ns_ = now_ns;
  ticks_since_origin_ = 0;
  owed_s_ = 0.0;
}

void SteppedRig::pass(double duration_s, Recorder& recorder) {
  // Ticks lie at the grid origin + n/rate; the remainder of a duration is carried over to the next
  // call, so that many short waits take as long as one long wait.
  owed_s_ += duration_s;
  const double rate_Hz = settings_.servo.rate_Hz;
  const auto ticks = static_cast<std::int64_t>(std::floor(owed_s_ * rate_Hz + 1e-9));
  owed_s_ -= static_cast<double>(ticks) / rate_Hz;
  for (std::int64_t tick = 0; tick < ticks; ++tick) {
    ++ticks_since_origin_;
    const double since_origin_ns = static_cast<double>(ticks_since_origin_) * 1e9 / rate_Hz;
    clock_.move_to(grid_origin_ns_ + std::llround(since_origin_ns));
    assembly_->loop.heartbeat();
    if (stop_wanted_.load()) assembly_->loop.emergency_stop();
    assembly_->loop.tick(clock_.now_ns());
    if (tick % kTicksBetweenDrains == kTicksBetweenDrains - 1) recorder.drain(records());
  }
  recorder.drain(records());
}

namespace {

/// Sets a scripted stall to take real time.
SimulatedDeviceSettings in_real_time(SimulatedDeviceSettings settings) {
  settings.sleep = [](double duration_s) {
    std::this_thread::sleep_for(std::chrono::duration<double>(duration_s));
  };
  return settings;
}

}  // namespace

RealTimeRig::RealTimeRig(const RigSettings& settings, const HandHabits& habits,
                         const Random& random, Scheduling scheduling, std::int64_t not_before_ns)
    : RealTimeRig(settings, habits, random, scheduling, not_before_ns,
                  [&settings, &random](VirtualHand& hand) {
                    return std::make_unique<SimulatedDevice>(
                        hand, with_noise(in_real_time(settings.device), random));
                  }) {}

struct RealTimeRig::Driven {
  Driven(const RigSettings& settings, const HandHabits& habits, const Random& random,
         const DeviceOpening& open)
      : hand(habits, random),
        device(open(hand)),
        records(static_cast<std::size_t>(kRing_s * settings.servo.rate_Hz)),
        loop((device->set_limits(settings.limits), *device), records, settings.servo) {}
  VirtualHand hand;
  std::unique_ptr<HapticDevice> device;
  RecordRing records;
  ServoLoop loop;
};

RealTimeRig::RealTimeRig(const RigSettings& settings, const HandHabits& habits,
                         const Random& random, Scheduling scheduling, std::int64_t not_before_ns,
                         const DeviceOpening& open)
    : clock_(not_before_ns),
      driven_(std::make_shared<Driven>(settings, habits, random, open)),
      thread_(driven_->loop, *driven_->device, scheduling, driven_) {}

RealTimeRig::~RealTimeRig() = default;

ServoLoop& RealTimeRig::loop() noexcept { return driven_->loop; }
RecordRing& RealTimeRig::records() noexcept { return driven_->records; }
VirtualHand& RealTimeRig::hand() noexcept { return driven_->hand; }
const DeviceCapability& RealTimeRig::capability() const noexcept {
  return driven_->device->capability();
}
const ForceLimits& RealTimeRig::limits() const noexcept { return driven_->device->limits(); }
std::string RealTimeRig::complaint() const { return driven_->device->complaint(); }

void RealTimeRig::prepare_attempt(const HandHabits& habits, const Random& random) {
  driven_->hand.set_habits(habits, random);
  driven_->device->begin_attempt();
}

void RealTimeRig::pass(double duration_s, Recorder& recorder) {
  const std::int64_t until_ns = clock_.now_ns() + std::llround(duration_s * 1e9);
  for (;;) {
    loop().heartbeat();
    recorder.drain(records(), clock_.ahead_ns());
    const double left_s = static_cast<double>(until_ns - clock_.now_ns()) * 1e-9;
    if (left_s <= 0.0) return;
    std::this_thread::sleep_for(std::chrono::duration<double>(std::min(left_s, kRealTimeSlice_s)));
  }
}

std::unique_ptr<RealTimeRig> open_rig(const NamedDevice& device, const DriverRegistry& drivers,
                                      const RigSettings& settings, const Random& hand,
                                      std::int64_t not_before_ns) {
  constexpr auto kScheduling = Scheduling::fifo_if_permitted;
  if (kind_of_device(device.name) == DeviceKind::simulated) {
    return std::make_unique<RealTimeRig>(settings, HandHabits{}, hand, kScheduling, not_before_ns);
  }
  DriverOptions options = device.options;
  options.recorded_hand = recorded_hand;
  return std::make_unique<RealTimeRig>(
      settings, HandHabits{}, hand, kScheduling, not_before_ns,
      [&](VirtualHand&) { return drivers.open(device.name, options); });
}

}  // namespace asperity
