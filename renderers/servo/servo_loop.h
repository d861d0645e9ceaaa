// The servo tick as a step function of time.

#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>

#include "device/haptic_device.h"
#include "renderers/force/force_renderer.h"
#include "renderers/servo/record_ring.h"

namespace asperity {

/// A renderer and the attempt it belongs to.
struct Presentation {
  std::uint64_t id = 0;  ///< not 0; comes back in every TickRecord of this presentation
  std::unique_ptr<ForceRenderer> renderer{};
};

/// Why the force is latched at zero.
enum class Fault : std::uint8_t {
  none,
  emergency_stop,
  device_lost,
  not_finite,  ///< the device or the renderer produced a number that is not finite
  workspace_left,
  repeated_misses,  ///< more than ServoSettings::misses_to_fault deadlines missed within a second
  standstill,  ///< no tick for ServoSettings::standstill_to_fault_s while a surface was presented
};
const char* name_of(Fault fault) noexcept;
/// Every fault but `none`, in the order of the enumeration.
inline constexpr std::array kFaults{Fault::emergency_stop,  Fault::device_lost,
                                    Fault::not_finite,      Fault::workspace_left,
                                    Fault::repeated_misses, Fault::standstill};

struct ServoSettings {
  double rate_Hz = 1000.0;
  double ramp_s = 0.050;             ///< a hand is never struck
  double heartbeat_timeout_s = 2.0;  ///< silence after which the surface fades out
  double heartbeat_fade_s = 0.5;
  int misses_to_fault = 100;         ///< within one second
  double workspace_margin_m = 0.02;  ///< how far outside the device's workspace is a fault
  /// Without a call from a device that keeps time itself (Pacing::theirs), after which it is lost.
  double silence_to_fault_s = 1e-9 * static_cast<double>(HapticDevice::kLongestSilence_ns);
  /// From tick to tick, while a surface is presented: what the hand did meanwhile is unknown, and so is what the motors
  /// do now. A test on a busy machine sets a longer time.
  double standstill_to_fault_s = 1e-9 * static_cast<double>(HapticDevice::kLongestSilence_ns);
};

/// One consistent look at the loop, from any thread.
struct ServoStatus {
  std::uint64_t ticks = 0;
  std::uint64_t missed_deadlines = 0;
  std::uint64_t presentation = 0;  ///< felt now, 0 in free space
  Fault fault = Fault::none;
};

/// Device × renderer → wrench → device, once per call of `tick`.
///
/// The loop has no thread and no clock: ServoThread paces it in real time, the conductor steps it
/// on a simulated clock. In a tick: read the device → round the ProbeState to what will be recorded
/// → clamp dt to [½, 4] periods → take a waiting presentation, `reset` it → `renderer.tick` → ramp
/// → limiter → send → push one TickRecord.
///
/// A standstill (the machine was suspended, the program stopped by a signal or a debugger, or starved) is a fault while
/// a surface is presented. Without one it is only counted, and what is presented next begins with a dt of one period.
///
/// What the caller may rely on:
/// - A presentation starts at gain 0 and rises to 1 over `ramp_s`, counted from the first tick with
///   penetration 0: a surface that appears around the probe stays silent until the probe has left
///   it.
/// - `withdraw` lowers the gain to 0 over `ramp_s`, then gives the presentation back.
/// - `present` while a surface is felt withdraws it first.
/// - After `heartbeat_timeout_s` without `heartbeat` the gain fades to 0 in `heartbeat_fade_s`. It
///   comes back, as a new presentation would, with the next heartbeat.
/// - A fault sends zero force in the same tick and latches it until `clear_fault`. Ticks go on and
///   are recorded; the renderer is not asked. Afterwards the presentation starts again from the
///   beginning: `reset`, gain 0, free space.
/// - A tick that begins more than a period after its deadline counts as one missed deadline and is
///   never made up; the gap is in the records' times.
/// - The renderer's first `dt_s` is one period, every other one the time since its last tick: the
///   ticks of a recording are enough to replay it (`offline/replay.h`).
///
/// Threads: `tick` belongs to one thread (the servo). `present`, `withdraw`, `collect` and
/// `heartbeat` belong to one other (the conductor). `emergency_stop`, `lose_device` and `status` may
/// come from any thread, `clear_fault` from the conductor's.
///
/// Real-time: `tick` does not allocate, free, lock, log or throw. Presentations are destroyed by
/// whoever collects them, never by the tick.
class ServoLoop final {
 public:
  /// Both must outlive the loop, which leaves the device at zero force.
  /// Errors: std::invalid_argument for settings that are not positive.
  ServoLoop(HapticDevice& device, RecordRing& records, const ServoSettings& settings);
  ~ServoLoop();
  ServoLoop(const ServoLoop&) = delete;
  ServoLoop& operator=(const ServoLoop&) = delete;

  const ServoSettings& settings() const noexcept { return settings_; }

  /// Hands over what is to be felt next. Throws std::logic_error while another one waits, and
  /// std::invalid_argument for a presentation without renderer or with id 0.
  void present(Presentation presentation);
  /// Ends what is felt now (or was waiting).
  void withdraw() noexcept;
  /// The presentation that has faded out; a null renderer while there is none.
  Presentation collect() noexcept;
  /// The conductor lives.
  void heartbeat() noexcept { heartbeats_.fetch_add(1, std::memory_order_relaxed); }

  void emergency_stop() noexcept;
  /// The device that should call has fallen silent: raises `device_lost` without a tick. From any thread.
  void lose_device() noexcept { raise(Fault::device_lost); }
  /// Lifts the fault that `status` showed to the caller; another one that has come since stays.
  void clear_fault(Fault seen) noexcept;
  ServoStatus status() const noexcept;

  /// Reads the clock that `now_ns` came from.
  using ClockReading = std::int64_t (*)() noexcept;

  /// One tick. `deadline_ns` is when it should have begun, `now_ns` when it did: equal when
  /// stepped. With a clock, the record states how long the tick took, and a standstill within the tick is seen before
  /// its force is sent.
  void tick(std::int64_t now_ns, std::int64_t deadline_ns, ClockReading clock = nullptr) noexcept;
  void tick(std::int64_t now_ns) noexcept { tick(now_ns, now_ns); }

 private:
  struct Handover;  // a presentation on its way through a mailbox
  struct Servo;     // what only the servo thread touches

  void exchange_presentations() noexcept;
  bool conductor_is_silent(std::int64_t now_ns) noexcept;
  void count_deadline(std::int64_t now_ns, std::int64_t deadline_ns, TickRecord& record) noexcept;
  void read_probe(std::int64_t now_ns, TickRecord& record) noexcept;
  void render(bool silent, double dt_s, TickRecord& record) noexcept;
  void send(double dt_s, TickRecord& record) noexcept;
  bool is_standstill(std::int64_t from_ns, std::int64_t to_ns) const noexcept;
  void publish_status() noexcept;
  void raise(Fault fault) noexcept;

  HapticDevice& device_;
  RecordRing& records_;
  ServoSettings settings_{};
  std::int64_t period_ns_ = 1;

  std::atomic<Handover*> inbox_{nullptr};
  std::atomic<Handover*> outbox_{nullptr};
  std::uint64_t handed_over_ = 0;                  // presentations so far; the conductor's
  std::atomic<std::uint64_t> withdrawn_up_to_{0};  // by that count
  std::atomic<std::uint64_t> heartbeats_{0};
  std::atomic<Fault> fault_{Fault::none};

  // The status as the servo last left it: consistent while the version is even and unchanged.
  std::atomic<std::uint64_t> status_version_{0};
  std::atomic<std::uint64_t> ticks_{0};
  std::atomic<std::uint64_t> missed_deadlines_{0};
  std::atomic<std::uint64_t> presentation_{0};

  std::unique_ptr<Servo> servo_;
};

}  // namespace asperity
