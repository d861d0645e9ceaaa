// A hand of a given path on a scripted device, and how far the force and the torque step.

#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "device/force_limiter.h"
#include "renderers/servo/servo_loop.h"
#include "tests/support/scripted_device.h"

namespace asperity {

inline constexpr double kForceLimit_N = 5.0;

/// The time within which growth is measured: a millisecond, or a tick where it is longer.
inline double window_s(double rate_Hz) { return std::max(ForceLimiter::kWindow_s, 1.0 / rate_Hz); }

inline double whole_change(const glm::dvec3& from, const glm::dvec3& to) {
  return glm::distance(from, to);
}

/// The largest step from any force that was held within the last millisecond, or from any torque.
class Steps {
 public:
  using Size = double (*)(const glm::dvec3& from, const glm::dvec3& to);
  explicit Steps(Size size) : size_(size) {}

  void take(std::int64_t now_ns, const glm::dvec3& vector) {
    held_.push_back({now_ns, last_});
    std::erase_if(held_, [&](const Held& held) { return now_ns - held.ended_ns > 999'000; });
    for (const Held& held : held_) largest = std::max(largest, size_(held.vector, vector));
    last_ = vector;
  }
  /// What follows is compared with this vector, and with nothing before it.
  void restart(const glm::dvec3& vector) {
    held_.clear();
    last_ = vector;
  }
  double largest = 0.0;  ///< N, or N·m

 private:
  struct Held {
    std::int64_t ended_ns = 0;
    glm::dvec3 vector{0.0};
  };
  Size size_;
  std::vector<Held> held_{};
  glm::dvec3 last_{0.0};
};

struct Measured {
  Steps open{growth};       ///< sent, with the limit of the growth wide open
  Steps limited{growth};    ///< with the limit as it is
  Steps own{whole_change};  ///< of the force of the surface itself, between ticks without a gap
  Steps open_torque{growth};
  Steps limited_torque{growth};
  double rendered_N = 0.0;
  double rendered_N_m = 0.0;
};

/// A hand of a given path on a scripted device. The path does not depend on the force, so that one run shows both.
class Scene {
 public:
  explicit Scene(double rate_Hz)
      : rate_Hz_(rate_Hz), loop_(device_, records_, {.rate_Hz = rate_Hz}) {}

  void place(const glm::dvec3& hand_m) { hand_m_ = hand_m; }
  void present(std::unique_ptr<ForceRenderer> renderer) {
    loop_.present({.id = ++id_, .renderer = std::move(renderer)});
  }
  void tick(const glm::dvec3& hand_m, double gap_s = 0.0) {
    const double step_s = gap_s > 0.0 ? gap_s : 1.0 / rate_Hz_;
    device_.probe.velocity_m_per_s = (hand_m - hand_m_) / step_s;
    hand_m_ = hand_m;
    tick_at(hand_m, step_s);
  }
  /// A reading elsewhere, of a hand at rest.
  void misread(const glm::dvec3& by_m) { tick_at(hand_m_ + by_m, 1.0 / rate_Hz_); }
  void rest(double duration_s) {
    for (int i = 0; i < duration_s * rate_Hz_; ++i) tick(hand_m_);
  }
  void move(const glm::dvec3& to_m, double speed_m_per_s) {
    const glm::dvec3 from_m = hand_m_;
    const int ticks =
        static_cast<int>(std::ceil(glm::distance(from_m, to_m) / speed_m_per_s * rate_Hz_));
    for (int i = 1; i <= ticks; ++i) {
      tick(from_m + (to_m - from_m) * (static_cast<double>(i) / ticks));
    }
  }
  /// What was before is not part of the event.
  void begin_event() {
    for (Steps* steps : {&measured.open, &measured.limited, &measured.own, &measured.open_torque,
                         &measured.limited_torque}) {
      steps->largest = 0.0;
    }
  }
  ServoLoop& loop() { return loop_; }

  double rate_Hz() const { return rate_Hz_; }
  /// In the last tick.
  const glm::dvec3& sent_N() const { return device_.last_sent.force_N; }
  const glm::dvec3& sent_N_m() const { return device_.last_sent.torque_N_m; }
  Measured measured{};

 private:
  void tick_at(const glm::dvec3& reading_m, double step_s) {
    loop_.heartbeat();
    device_.probe.position_m = reading_m;
    now_ns_ += std::llround(1e9 * step_s);
    loop_.tick(now_ns_, now_ns_);
    TickRecord record{};
    while (records_.pop(record)) take(record);
    (void)loop_.collect();
  }
  void take(const TickRecord& record) {
    measured.open.take(now_ns_, record.sent.force_N);
    measured.open_torque.take(now_ns_, record.sent.torque_N_m);
    if (record.has(TickFlag::fault_latched)) limiter_.reset();
    const Wrench limited = limiter_.limit(record.sent, 1.0 / rate_Hz_).wrench;
    measured.limited.take(now_ns_, limited.force_N);
    measured.limited_torque.take(now_ns_, limited.torque_N_m);
    measured.rendered_N = std::max(measured.rendered_N, glm::length(record.rendered.force_N));
    measured.rendered_N_m =
        std::max(measured.rendered_N_m, glm::length(record.rendered.torque_N_m));
    if (record.has(TickFlag::limited_not_finite) || !record.has(TickFlag::presenting) ||
        record.has(TickFlag::first_of_presentation) || record.has(TickFlag::gap_in_contact)) {
      measured.own.restart(record.rendered.force_N);
    } else {
      measured.own.take(now_ns_, record.rendered.force_N);
    }
  }

  double rate_Hz_;
  ScriptedDevice device_{{.name = "scripted",
                          .actuated_degrees_of_freedom = 6,
                          .peak_force_N = 100.0,
                          .may_rest_exactly = true},
                         {.force_N = kForceLimit_N, .slew_N = 1e6, .slew_N_m = 1e6}};
  RecordRing records_{64};
  ForceLimiter limiter_{ForceLimits{}};
  ServoLoop loop_;
  glm::dvec3 hand_m_{0.0};
  std::int64_t now_ns_ = 1'000'000'000;
  std::uint64_t id_ = 0;
};

}  // namespace asperity
