// Implements the servo tick.

#include "renderers/servo/servo_loop.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "device/reading_check.h"
#include "device/refusal.h"
#include "renderers/servo/contact.h"
#include "renderers/servo/gap_bridge.h"
#include "renderers/servo/servo_time.h"

namespace asperity {
namespace {

bool is_finite(const glm::dvec3& v) noexcept {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool is_finite(const ProbeState& probe) noexcept {
  const glm::dquat& q = probe.orientation;
  return is_finite(probe.position_m) && is_finite(probe.velocity_m_per_s) &&
         is_finite(probe.angular_velocity_rad_per_s) && std::isfinite(q.w) && std::isfinite(q.x) &&
         std::isfinite(q.y) && std::isfinite(q.z);
}

std::int32_t saturated(std::int64_t duration_ns) noexcept {
  return static_cast<std::int32_t>(
      std::clamp<std::int64_t>(duration_ns, std::numeric_limits<std::int32_t>::min(),
                               std::numeric_limits<std::int32_t>::max()));
}

void set(TickRecord& record, TickFlag flag) noexcept {
  record.flags |= static_cast<std::uint32_t>(flag);
}

// A longer time between two ticks is a gap.
constexpr std::int64_t kLongestStep_periods = 2;

// Missed deadlines older than this are not counted.
constexpr std::int64_t kMissWindow_ns = 1'000'000'000;

}  // namespace

const char* name_of(Fault fault) noexcept {
  switch (fault) {
    case Fault::none:
      return "none";
    case Fault::emergency_stop:
      return "emergency_stop";
    case Fault::device_lost:
      return "device_lost";
    case Fault::not_finite:
      return "not_finite";
    case Fault::workspace_left:
      return "workspace_left";
    case Fault::repeated_misses:
      return "repeated_misses";
    case Fault::standstill:
      return "standstill";
  }
  return "unknown";
}

struct ServoLoop::Handover {
  Presentation presentation{};
  std::uint64_t number = 0;  // the first presentation of the loop has number 1
};

struct ServoLoop::Servo {
  std::unique_ptr<Handover> felt{};
  bool leaving = false;     // withdrawn, or another one is waiting
  bool to_be_reset = true;  // the renderer has not received a sample of this stretch yet
  bool has_been_in_free_space = false;
  bool fading_for_silence = false;
  double gain = 0.0;

  explicit Servo(const DeviceCapability& capability) : readings(capability.maximum_speed_m_per_s) {}

  ReadingCheck readings;
  GapBridge bridge{};
  Wrench last_sent{};
  bool was_in_contact = false;
  ProbeState last_probe{};
  std::int64_t last_rendered_ns = 0;
  std::int64_t last_tick_ns = 0;
  bool has_ticked = false;

  std::uint64_t heartbeats_seen = 0;
  std::int64_t last_heartbeat_ns = 0;

  std::uint64_t ticks = 0;
  std::uint64_t missed = 0;
  std::vector<std::int64_t> recent_misses_ns{};  // a ring of the last misses_to_fault + 1

  // The next contact is rendered as that of a new presentation.
  void start_over() noexcept {
    to_be_reset = true;
    has_been_in_free_space = false;
    fading_for_silence = false;
    gain = 0.0;
  }
};

ServoLoop::ServoLoop(HapticDevice& device, RecordRing& records, const ServoSettings& settings)
    : device_(device),
      records_(records),
      settings_(settings),
      servo_(std::make_unique<Servo>(device.capability())) {
  require_positive("ServoSettings::rate_Hz", settings.rate_Hz);
  require_positive("ServoSettings::ramp_s", settings.ramp_s);
  require_positive("ServoSettings::heartbeat_timeout_s", settings.heartbeat_timeout_s);
  require_positive("ServoSettings::heartbeat_fade_s", settings.heartbeat_fade_s);
  require_positive("ServoSettings::misses_to_fault", settings.misses_to_fault);
  require_positive("ServoSettings::workspace_margin_m", settings.workspace_margin_m);
  require_positive("ServoSettings::silence_to_fault_s", settings.silence_to_fault_s);
  require_positive("ServoSettings::standstill_to_fault_s", settings.standstill_to_fault_s);
  period_ns_ = period_ns_of(settings.rate_Hz);
  servo_->recent_misses_ns.assign(static_cast<std::size_t>(settings.misses_to_fault) + 1, 0);
}

ServoLoop::~ServoLoop() {
  device_.zero_force();
  delete inbox_.exchange(nullptr);
  delete outbox_.exchange(nullptr);
}

void ServoLoop::present(Presentation presentation) {
  if (!presentation.renderer)
    throw std::invalid_argument("Presentation::renderer is missing; set it");
  if (presentation.id == 0)
    throw std::invalid_argument("Presentation::id is 0; set it to another number");
  if (inbox_.load(std::memory_order_acquire) != nullptr) {
    throw std::logic_error(
        "a presentation is already waiting for the servo loop; wait until the loop has taken it");
  }
  inbox_.store(new Handover{std::move(presentation), ++handed_over_}, std::memory_order_release);
}

void ServoLoop::withdraw() noexcept {
  withdrawn_up_to_.store(handed_over_, std::memory_order_release);
}

Presentation ServoLoop::collect() noexcept {
  const std::unique_ptr<Handover> back(outbox_.exchange(nullptr, std::memory_order_acquire));
  return back ? std::move(back->presentation) : Presentation{};
}

void ServoLoop::emergency_stop() noexcept {
  fault_.store(Fault::emergency_stop, std::memory_order_release);
}

void ServoLoop::clear_fault(Fault seen) noexcept {
  // Before: once it is cleared, the servo may set it again.
  if (seen == Fault::device_lost) position_jumped_.store(false, std::memory_order_release);
  fault_.compare_exchange_strong(seen, Fault::none, std::memory_order_acq_rel);
}

void ServoLoop::raise(Fault fault) noexcept {
  Fault none = Fault::none;  // the first fault is kept: it explains the later ones
  fault_.compare_exchange_strong(none, fault, std::memory_order_acq_rel);
}

ServoStatus ServoLoop::status() const noexcept {
  ServoStatus status{};
  for (;;) {
    const std::uint64_t version = status_version_.load(std::memory_order_acquire);
    status.ticks = ticks_.load(std::memory_order_acquire);
    status.missed_deadlines = missed_deadlines_.load(std::memory_order_acquire);
    status.presentation = presentation_.load(std::memory_order_acquire);
    if (version % 2 == 0 && version == status_version_.load(std::memory_order_relaxed)) break;
  }
  status.fault = fault_.load(std::memory_order_acquire);
  status.position_jumped =
      status.fault == Fault::device_lost && position_jumped_.load(std::memory_order_acquire);
  return status;
}

TickProgress ServoLoop::progress() const noexcept {
  return {.begun = begun_.load(std::memory_order_acquire),
          .ended = ticks_.load(std::memory_order_acquire),
          .presenting = presenting_.load(std::memory_order_acquire),
          .rendering = rendering_.load(std::memory_order_acquire),
          .sending = sending_.load(std::memory_order_acquire)};
}

void ServoLoop::publish_status() noexcept {
  const Servo& servo = *servo_;
  // A reader that sees one of the values below through their release also sees the odd version.
  const std::uint64_t version = status_version_.load(std::memory_order_relaxed);
  status_version_.store(version + 1, std::memory_order_relaxed);
  ticks_.store(servo.ticks, std::memory_order_release);
  missed_deadlines_.store(servo.missed, std::memory_order_release);
  presentation_.store(servo.felt ? servo.felt->presentation.id : 0, std::memory_order_release);
  status_version_.store(version + 2, std::memory_order_release);
}

void ServoLoop::exchange_presentations() noexcept {
  Servo& servo = *servo_;
  const bool another_waits = inbox_.load(std::memory_order_acquire) != nullptr;
  if (servo.felt) {
    servo.leaving =
        another_waits || servo.felt->number <= withdrawn_up_to_.load(std::memory_order_acquire);
    if (servo.leaving && servo.gain == 0.0 && outbox_.load(std::memory_order_relaxed) == nullptr) {
      outbox_.store(servo.felt.release(), std::memory_order_release);
    }
  }
  if (!servo.felt && another_waits) {
    servo.felt.reset(inbox_.exchange(nullptr, std::memory_order_acq_rel));
    servo.leaving = servo.felt->number <= withdrawn_up_to_.load(std::memory_order_acquire);
    servo.start_over();
  }
  presenting_.store(servo.felt != nullptr, std::memory_order_release);
}

bool ServoLoop::is_standstill(std::int64_t from_ns, std::int64_t to_ns) const noexcept {
  return static_cast<double>(to_ns - from_ns) * 1e-9 > settings_.standstill_to_fault_s;
}

bool ServoLoop::conductor_is_silent(std::int64_t now_ns) noexcept {
  Servo& servo = *servo_;
  const std::uint64_t heartbeats = heartbeats_.load(std::memory_order_relaxed);
  if (heartbeats != servo.heartbeats_seen || !servo.has_ticked) {
    servo.heartbeats_seen = heartbeats;
    servo.last_heartbeat_ns = now_ns;
  }
  return static_cast<double>(now_ns - servo.last_heartbeat_ns) * 1e-9 >
         settings_.heartbeat_timeout_s;
}

void ServoLoop::count_deadline(std::int64_t now_ns, std::int64_t deadline_ns,
                               TickRecord& record) noexcept {
  Servo& servo = *servo_;
  record.lateness_ns = saturated(now_ns - deadline_ns);
  if (now_ns - deadline_ns <= period_ns_) return;
  set(record, TickFlag::missed_deadline);
  const std::size_t depth = servo.recent_misses_ns.size();
  servo.recent_misses_ns[servo.missed % depth] = now_ns;
  ++servo.missed;
  // With this miss there are misses_to_fault + 1 of them; the oldest is in the next slot.
  if (servo.missed >= depth &&
      now_ns - servo.recent_misses_ns[servo.missed % depth] <= kMissWindow_ns) {
    raise(Fault::repeated_misses);
  }
}

void ServoLoop::read_probe(std::int64_t now_ns, TickRecord& record) noexcept {
  Servo& servo = *servo_;
  const std::optional<ProbeState> probe = device_.read(now_ns);
  if (!probe) {
    raise(Fault::device_lost);
    set(record, TickFlag::device_lost);
    record.probe = servo.last_probe;
    record.probe.time_ns = now_ns;
    return;
  }
  record.probe = rounded_for_recording(*probe);
  if (!is_finite(record.probe)) {
    raise(Fault::not_finite);
    return;
  }
  if (fault_.load(std::memory_order_acquire) != Fault::none) {
    servo.readings.restart();
  } else if (const auto verdict = servo.readings.judge(
                 record.probe, device_.was_read_again() ? ReadingCheck::Origin::repeated
                                                        : ReadingCheck::Origin::fresh);
             verdict != ReadingCheck::Verdict::plausible) {
    set(record, TickFlag::reading_held);
    record.probe = servo.last_probe;
    record.probe.time_ns = now_ns;
    if (verdict == ReadingCheck::Verdict::lost) {
      position_jumped_.store(true, std::memory_order_release);
      raise(Fault::device_lost);
      set(record, TickFlag::device_lost);
    }
    return;
  }
  servo.last_probe = record.probe;
  const DeviceCapability& capability = device_.capability();
  for (int axis = 0; axis < 3; ++axis) {
    const double position_m = record.probe.position_m[axis];
    if (position_m < capability.workspace_minimum_m[axis] - settings_.workspace_margin_m ||
        position_m > capability.workspace_maximum_m[axis] + settings_.workspace_margin_m) {
      raise(Fault::workspace_left);
    }
  }
}

void ServoLoop::render(bool silent, double dt_s, TickRecord& record) noexcept {
  Servo& servo = *servo_;
  ForceRenderer& renderer = *servo.felt->presentation.renderer;
  set(record, TickFlag::presenting);
  double renderer_dt_s = 1.0 / settings_.rate_Hz;
  rendering_.store(true, std::memory_order_release);
  if (servo.to_be_reset) {
    set(record, TickFlag::first_of_presentation);
    renderer.reset(record.probe);
    servo.to_be_reset = false;
  } else {
    renderer_dt_s = clamped_dt_s(servo.last_rendered_ns, record.probe.time_ns, settings_.rate_Hz);
  }
  servo.last_rendered_ns = record.probe.time_ns;

  const RenderedTick rendered = renderer.tick(record.probe, renderer_dt_s);
  rendering_.store(false, std::memory_order_release);
  record.rendered = rendered.wrench;
  record.penetration_m = rendered.penetration_m;
  if (rendered.part != 0) record.presentation = rendered.part;
  if (!is_finite_as_stored(rendered)) {
    set(record, TickFlag::limited_not_finite);
    raise(Fault::not_finite);
    return;
  }

  servo.fading_for_silence = servo.fading_for_silence || silent;
  if (silent) set(record, TickFlag::heartbeat_lost);
  if (servo.leaving) {
    servo.gain = std::max(0.0, servo.gain - dt_s / settings_.ramp_s);
  } else if (servo.fading_for_silence) {
    servo.gain = std::max(0.0, servo.gain - dt_s / settings_.heartbeat_fade_s);
    servo.has_been_in_free_space = false;
    servo.fading_for_silence = silent || servo.gain > 0.0;
  } else if (servo.has_been_in_free_space) {
    servo.gain = std::min(1.0, servo.gain + dt_s / settings_.ramp_s);
  } else {
    servo.has_been_in_free_space = !is_in_contact(rendered);
  }
}

void ServoLoop::bridge_gap(std::int64_t gap_ns, TickRecord& record) noexcept {
  Servo& servo = *servo_;
  const bool in_contact = is_in_contact(record);
  if ((in_contact || servo.was_in_contact) && gap_ns > kLongestStep_periods * period_ns_) {
    set(record, TickFlag::gap_in_contact);
    servo.bridge.begin(servo.last_sent, 1e-9 * static_cast<double>(gap_ns));
  }
  servo.was_in_contact = in_contact;
}

void ServoLoop::send(double elapsed_s, bool stood, TickRecord& record) noexcept {
  sending_.store(true, std::memory_order_release);
  send_wanted_or_zero(elapsed_s, stood, record);
  sending_.store(false, std::memory_order_release);
}

void ServoLoop::send_wanted_or_zero(double elapsed_s, bool stood, TickRecord& record) noexcept {
  Servo& servo = *servo_;
  if (!stood && fault_.load(std::memory_order_acquire) == Fault::none) {
    const bool presenting = record.has(TickFlag::presenting);
    record.gain = presenting ? servo.gain : 0.0;
    Wrench wanted{};
    if (presenting && servo.gain > 0.0) {
      wanted.force_N = servo.gain * record.rendered.force_N;
      wanted.torque_N_m = servo.gain * record.rendered.torque_N_m;
    }
    wanted = servo.bridge.approach(wanted, elapsed_s);
    if (const std::optional<LimitedWrench> sent = device_.push(wanted, elapsed_s)) {
      record.sent = sent->wrench;
      record.flags |= sent->reasons;
      servo.last_sent = sent->wrench;
      return;
    }
    raise(Fault::device_lost);
    set(record, TickFlag::device_lost);
  }
  set(record, TickFlag::fault_latched);
  device_.zero_force();
  servo.last_sent = Wrench{};
  servo.bridge = GapBridge{};
  servo.start_over();
  record.gain = 0.0;
}

void ServoLoop::tick(std::int64_t now_ns, std::int64_t deadline_ns, ClockReading clock) noexcept {
  Servo& servo = *servo_;
  begun_.store(servo.ticks + 1, std::memory_order_release);
  const double period_s = 1.0 / settings_.rate_Hz;
  const double dt_s =
      servo.has_ticked ? clamped_dt_s(servo.last_tick_ns, now_ns, settings_.rate_Hz) : period_s;
  const std::int64_t gap_ns = servo.has_ticked ? now_ns - servo.last_tick_ns : period_ns_;
  const double elapsed_s = std::min(period_s, static_cast<double>(gap_ns) * 1e-9);
  // Checked before a waiting presentation is accepted: that one has not produced a force yet.
  if (servo.felt && is_standstill(servo.last_tick_ns, now_ns)) raise(Fault::standstill);
  TickRecord record{};
  count_deadline(now_ns, deadline_ns, record);
  exchange_presentations();
  const bool silent = conductor_is_silent(now_ns);
  servo.has_ticked = true;
  servo.last_tick_ns = now_ns;

  read_probe(now_ns, record);
  if (servo.felt) record.presentation = servo.felt->presentation.id;
  if (servo.felt && fault_.load(std::memory_order_acquire) == Fault::none) {
    render(silent, dt_s, record);
  }
  // A standstill that was raised from outside may be cleared before the force is sent: the force is of an old position all
  // the same.
  const bool stood = servo.felt && clock != nullptr && is_standstill(now_ns, clock());
  if (stood) raise(Fault::standstill);
  bridge_gap(gap_ns, record);
  send(elapsed_s, stood, record);

  ++servo.ticks;
  publish_status();
  if (clock != nullptr) record.execution_ns = saturated(clock() - now_ns);
  records_.push(record);
}

}  // namespace asperity
