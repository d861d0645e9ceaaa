// Reads the hand and pushes it; nothing reaches the motors past the limiter.

#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "device/device_capability.h"
#include "device/force_limiter.h"
#include "device/pose_watch.h"
#include "device/probe_state.h"

namespace asperity {

/// What a device that keeps time itself (Pacing::theirs) calls, once for each reading that it has;
/// inside the call it is read once and pushed once.
struct TickCall {
  void (*function)(void* argument) noexcept = nullptr;
  void* argument = nullptr;
  double rate_Hz = 1000.0;  ///< requested; a device that cannot reach it calls as often as it can
};

/// A force-feedback device, real or simulated.
///
/// Every wrench passes the limiter that this class owns; a driver sees only limited ones. A driver
/// implements `do_read`, `do_send` and nothing about safety. The motors are at zero after
/// construction, after `zero_force` and after destruction (each driver's destructor sends zero).
///
/// A pose that is frozen (pose_watch.h) is not accepted, whatever the driver reports: the device then does not
/// answer until it changes. Only a hand that is computed may rest to the last bit
/// (DeviceCapability::may_rest_exactly).
///
/// Errors: the constructor throws std::invalid_argument for a device that has motors and no
/// positive peak force, or for a limit that is not positive and finite.
///
/// Real-time: `read`, `push` and `zero_force` run on the servo thread; they do not allocate, lock,
/// log or throw. Drivers hold themselves to the same.
class HapticDevice {
 public:
  virtual ~HapticDevice() = default;
  HapticDevice(const HapticDevice&) = delete;
  HapticDevice& operator=(const HapticDevice&) = delete;

  /// A device that has reported nothing new for so long does not answer: its driver reports this, and for one that
  /// keeps time itself its servo loop.
  static constexpr std::int64_t kLongestSilence_ns = 50'000'000;

  const DeviceCapability& capability() const noexcept { return capability_; }

  /// Before the loop starts. Limits above the device's peak force are lowered to it.
  /// Errors: std::invalid_argument for a limit that is not positive and finite.
  void set_limits(const ForceLimits& limits);
  const ForceLimits& limits() const noexcept { return limiter_.limits(); }

  /// The hand at `now_ns`; nothing when the device does not answer (it is lost).
  std::optional<ProbeState> read(std::int64_t now_ns) noexcept;

  /// The last `read` brought nothing new: it was the reading before, again.
  bool was_read_again() const noexcept { return is_read_again_; }

  /// Limits `wanted` and sends it; returns what was really sent. `elapsed_s` is the time since the last push, at most a
  /// nominal period (ForceLimiter::limit). A device with fewer than six actuated
  /// degrees of freedom gets the force alone, one without motors nothing: zero is what it was sent. No
  /// answer when the device is lost; when it comes back, its force rises from zero.
  std::optional<LimitedWrench> push(const Wrench& wanted, double elapsed_s) noexcept;

  /// Zero force at once, past the slew limit.
  void zero_force() noexcept;

  /// Zero force while a tick does not return: the servo thread is in `read`, in `push`, or in between. From one other
  /// thread, which waits for nothing that the servo thread may hold, and calls it again and again until the tick returns,
  /// because a push that was under way can come after it. The pushes of the ticks that follow have the same effect as
  /// before. How far it reaches depends on the driver (docs/devices.md). It may not return where the manufacturer's
  /// functions do not.
  virtual void zero_force_from_outside() noexcept = 0;

  /// For a device with Pacing::theirs: from now on its own thread calls. While it does, `read`, `push`
  /// and `zero_force` belong to that thread, inside the call.
  /// Errors: std::logic_error for a device that we pace; std::runtime_error with a sentence when the
  /// device refuses.
  virtual void start_calls(const TickCall& call);
  /// When it returns no call is under way and none will come: a tick is waited for, a thread that is
  /// stuck in the maker's code shut out for ever (call_gate.h), within two seconds where the maker's own
  /// functions return (docs/devices.md). The motors are at zero, or cannot be reached. May be called at any time and twice.
  virtual void stop_calls() noexcept {}
  /// For who watches over these calls: none has begun for longer than the device may be silent. From any thread.
  void note_silence() noexcept { silence_.store(Silence::silent, std::memory_order_relaxed); }

  /// An attempt begins: a device that plays a recording begins anew with the next reading. From any thread.
  virtual void begin_attempt() noexcept {}

  /// Keeps `what` for as long as the device exists, until after its driver has set the motors to zero.
  void keep(std::shared_ptr<const void> what) noexcept { kept_ = std::move(what); }

  /// What is wrong with the device now, in sentences for the person who must act: that its pose is
  /// frozen, and its driver's `trouble`. Empty while all is well. From any thread but the servo's.
  std::string complaint() const;
  /// The driver's part of it: why the device does not answer, what it refuses. Empty again once that is over.
  virtual std::string trouble() const { return {}; }

 protected:
  HapticDevice(DeviceCapability capability, const ForceLimits& limits);

  /// For `do_read`: nothing new came, and this is the last reading again. It is no sign of a frozen pose.
  void read_again() noexcept { is_read_again_ = true; }
  /// For `do_send`: the motors could give no more than this. `push` returns it as limited in force.
  void gave_only(const Wrench& given) noexcept { given_ = given; }
  /// For `do_send`: the motors gave less, by an unknown amount. `push` marks the wrench as limited
  /// in force and returns it as it was sent.
  void gave_less() noexcept { gave_less_ = true; }
  /// For `trouble` of one that keeps time itself: it fell silent, and has not called for long since.
  bool has_fallen_silent() const noexcept {
    return silence_.load(std::memory_order_relaxed) != Silence::none;
  }

 private:
  /// Fills `state`, whose time is already `now_ns`; false when the device does not answer.
  virtual bool do_read(std::int64_t now_ns, ProbeState& state) noexcept = 0;
  /// False when the device does not take it.
  virtual bool do_send(const Wrench& limited) noexcept = 0;

  /// Until a silence is reported as over, to callers that ask a few times a second.
  static constexpr std::int64_t kToForgetSilence_ns = 500'000'000;
  enum class Silence { none, silent, just_over };

  void forget_silence(std::int64_t now_ns) noexcept;
  void note_push(double force_N) noexcept;

  std::shared_ptr<const void> kept_{};
  DeviceCapability capability_{};
  ForceLimiter limiter_;
  std::optional<Wrench> given_{};
  bool gave_less_ = false;
  bool is_read_again_ = false;
  PoseWatch pose_{};
  double pushed_N_ = 0.0;
  double weakest_N_ = 0.0;  // push since the last new reading
  std::atomic<bool> is_frozen_{false};
  std::atomic<Silence> silence_{Silence::none};
  std::int64_t silence_over_ns_ = 0;  ///< the first reading after it
};

}  // namespace asperity
