// Declares the servo tick, a function that receives the time.

#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>

#include "device/haptic_device.h"
#include "renderers/force/force_renderer.h"
#include "renderers/servo/record_ring.h"

namespace asperity {

/// A renderer and the id of the attempt that it belongs to.
struct Presentation {
  /// Not 0; stored in every TickRecord of this presentation, except where the renderer states another surface
  /// (RenderedTick::part), whose number is stored instead.
  std::uint64_t id = 0;
  std::unique_ptr<ForceRenderer> renderer{};
};

/// The reason why the force is latched at zero.
enum class Fault : std::uint8_t {
  none,
  emergency_stop,
  device_lost,
  /// The device or the renderer produced a number that is not finite as it is stored (rendered_tick.h).
  not_finite,
  workspace_left,
  repeated_misses,  ///< more than ServoSettings::misses_to_fault deadlines missed within a second
  standstill,  ///< no tick for ServoSettings::standstill_to_fault_s while a surface was presented
};
const char* name_of(Fault fault) noexcept;
/// All faults except `none`, in the order of the enumeration.
inline constexpr std::array kFaults{Fault::emergency_stop,  Fault::device_lost,
                                    Fault::not_finite,      Fault::workspace_left,
                                    Fault::repeated_misses, Fault::standstill};

struct ServoSettings {
  double rate_Hz = 1000.0;
  double ramp_s = 0.050;             ///< avoids a sudden onset of force
  double heartbeat_timeout_s = 2.0;  ///< time without a heartbeat after which the surface fades out
  double heartbeat_fade_s = 0.5;
  int misses_to_fault = 100;         ///< within one second
  double workspace_margin_m = 0.02;  ///< distance outside the device's workspace that is a fault
  /// Time without a call from a device with Pacing::theirs after which the device is lost.
  double silence_to_fault_s = 1e-9 * static_cast<double>(HapticDevice::kLongestSilence_ns);
  /// Time between two ticks while a surface is presented after which a standstill is reported: the motion of the hand
  /// in between and the present state of the motors are unknown. A test on a busy machine sets a longer time.
  double standstill_to_fault_s = 1e-9 * static_cast<double>(HapticDevice::kLongestSilence_ns);
};

/// A consistent snapshot of the loop, available to any thread.
struct ServoStatus {
  std::uint64_t ticks = 0;
  std::uint64_t missed_deadlines = 0;
  std::uint64_t presentation = 0;  ///< being rendered; 0 in free space
  Fault fault = Fault::none;
  /// The fault is `device_lost` although the device responds: its readings stayed implausible.
  bool position_jumped = false;
};

/// The ticks of the loop, seen from outside (tick_watch.h). Any thread can read it, also while a tick is under way.
struct TickProgress {
  std::uint64_t begun = 0;
  std::uint64_t ended = 0;
  bool presenting = false;  ///< the loop has a presentation, which its ticks render
  bool rendering = false;   ///< the renderer has been called and has not returned
  bool sending = false;     ///< the driver has been given a wrench and has not returned

  /// Whether the tick that was under way at `earlier` still is.
  bool hangs_since(const TickProgress& earlier) const noexcept {
    return begun != ended && begun == earlier.begun && ended == earlier.ended;
  }
};

/// Reads the device, runs the renderer and sends the wrench, once per call of `tick`.
///
/// The loop has no thread and no clock: ServoThread paces it in real time, and the conductor steps it on a simulated
/// clock. Each tick does the following: read the device → round the ProbeState to the recorded precision → clamp dt to
/// [½, 4] periods → accept a waiting presentation and `reset` it → `renderer.tick` → ramp → bridge of a gap → limiter →
/// send → push one TickRecord.
///
/// A standstill (the machine was suspended, or the program was stopped by a signal or a debugger, or starved of
/// processor time) is a fault while a surface is presented. Otherwise it is only counted, and the next presentation
/// begins with a dt of one period. A tick that does not return can detect nothing: then the watch of the thread raises the
/// fault (tick_watch.h).
///
/// Guarantees:
/// - A presentation starts at gain 0 and rises to 1 over `ramp_s`, counted from the first tick with penetration 0: a
///   surface that appears around the probe produces no force until the probe has left it.
/// - `withdraw` lowers the gain to 0 over `ramp_s`, then returns the presentation through `collect`.
/// - `present` during another presentation withdraws that one first.
/// - After `heartbeat_timeout_s` without `heartbeat` the gain fades to 0 within `heartbeat_fade_s`. With the next
///   heartbeat the surface returns in the same way as a new presentation.
/// - A fault sends zero force in the same tick and latches it until `clear_fault`. Ticks continue and are recorded; the
///   renderer is not called. Afterwards the presentation restarts from the beginning: `reset`, gain 0, free space.
/// - A reading that implies a motion faster than the device's maximum_speed_m_per_s is replaced by the last one for at most
///   2 ms; then the fault is `device_lost` (device/reading_check.h). This applies in free space too, because a position
///   that has jumped there is wrong in every later contact. While a fault is latched, readings are not judged, and the
///   first one after it is accepted.
/// - After a gap of more than two periods in contact, the force continues from the one that was sent and approaches the
///   surface's over the length of the gap (gap_bridge.h), with or without free space.
/// - A tick that begins more than one period after its deadline counts as one missed deadline and is not made up for;
///   the gap is visible in the times of the records.
/// - The renderer's first `dt_s` is one period; every other one is the time since its previous tick. The ticks of a
///   recording are therefore sufficient to replay it (`offline/replay.h`).
///
/// Threads: `tick` belongs to one thread (the servo). `present`, `withdraw`, `collect` and `heartbeat` belong to one
/// other thread (the conductor). `emergency_stop`, `lose_device`, `stand_still`, `status` and `progress` may be called from
/// any thread, `clear_fault` from the conductor's.
///
/// Real-time: `tick` does not allocate, free, lock, log or throw. The caller of `collect` destroys a presentation; the
/// tick never does.
class ServoLoop final {
 public:
  /// `device` and `records` must outlive the loop. On destruction the loop sets the device to zero force.
  /// Errors: std::invalid_argument for settings that are not positive.
  ServoLoop(HapticDevice& device, RecordRing& records, const ServoSettings& settings);
  ~ServoLoop();
  ServoLoop(const ServoLoop&) = delete;
  ServoLoop& operator=(const ServoLoop&) = delete;

  const ServoSettings& settings() const noexcept { return settings_; }

  /// Queues the next presentation. Throws std::logic_error while another one is waiting, and std::invalid_argument for
  /// a presentation without a renderer or with id 0.
  void present(Presentation presentation);
  /// Ends the current or the waiting presentation.
  void withdraw() noexcept;
  /// The presentation that has faded out; its renderer is null if there is none.
  Presentation collect() noexcept;
  /// Signals that the conductor is running.
  void heartbeat() noexcept { heartbeats_.fetch_add(1, std::memory_order_relaxed); }

  void emergency_stop() noexcept;
  /// Raises `device_lost` without a tick, for a device with its own pacing that has stopped calling. From any thread.
  void lose_device() noexcept { raise(Fault::device_lost); }
  /// Raises `standstill` without a tick, where one does not return or none begins. From any thread.
  void stand_still() noexcept { raise(Fault::standstill); }
  /// Clears the fault `seen`, which the caller read from `status`; a different fault that has been raised since
  /// remains.
  void clear_fault(Fault seen) noexcept;
  ServoStatus status() const noexcept;
  TickProgress progress() const noexcept;

  /// Reads the clock that `now_ns` was read from.
  using ClockReading = std::int64_t (*)() noexcept;

  /// Runs one tick. `deadline_ns` is when it was due, `now_ns` when it began; the two are equal when the loop is
  /// stepped. With a clock, the record contains the duration of the tick, and a standstill within the tick is detected
  /// before its force is sent.
  void tick(std::int64_t now_ns, std::int64_t deadline_ns, ClockReading clock = nullptr) noexcept;
  void tick(std::int64_t now_ns) noexcept { tick(now_ns, now_ns); }

 private:
  struct Handover;  // a presentation in transit through a mailbox
  struct Servo;     // the state that only the servo thread accesses

  void exchange_presentations() noexcept;
  bool conductor_is_silent(std::int64_t now_ns) noexcept;
  void count_deadline(std::int64_t now_ns, std::int64_t deadline_ns, TickRecord& record) noexcept;
  void read_probe(std::int64_t now_ns, TickRecord& record) noexcept;
  void render(bool silent, double dt_s, TickRecord& record) noexcept;
  void bridge_gap(std::int64_t gap_ns, TickRecord& record) noexcept;
  void send(double elapsed_s, bool stood, TickRecord& record) noexcept;
  void send_wanted_or_zero(double elapsed_s, bool stood, TickRecord& record) noexcept;
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
  std::atomic<std::uint64_t> withdrawn_up_to_{0};  // in terms of that number
  std::atomic<std::uint64_t> heartbeats_{0};
  std::atomic<Fault> fault_{Fault::none};
  std::atomic<bool> position_jumped_{false};  // set before the fault is raised

  // The status after the servo's last tick; consistent while the version is even and unchanged.
  std::atomic<std::uint64_t> status_version_{0};
  std::atomic<std::uint64_t> ticks_{0};
  std::atomic<std::uint64_t> missed_deadlines_{0};
  std::atomic<std::uint64_t> presentation_{0};

  // For an observer of a tick that is under way.
  std::atomic<std::uint64_t> begun_{0};
  std::atomic<bool> presenting_{false};
  std::atomic<bool> rendering_{false};
  std::atomic<bool> sending_{false};

  std::unique_ptr<Servo> servo_;
};

}  // namespace asperity
