// Implements strokes of a simulated hand in a closed loop.

#include "renderers/offline/friction_stroke.h"

#include <algorithm>
#include <cmath>

#include "analysis/numbers/random.h"
#include "analysis/signals/filters.h"
#include "device/refusal.h"
#include "renderers/servo/servo_time.h"
#include "renderers/servo/tick_record.h"

namespace asperity {
namespace {

constexpr HighPass kFelt{.order = 4, .cutoff_Hz = 30.0};
constexpr double kTransient_s = 0.1;
constexpr double kSameSpeed_m_per_s = 1e-9;
constexpr double kForceLimit_N = 10.0;  // friction is to be seen, not the limit

/// Reports how long the hand has intended to move at one speed along the surface.
class SteadyIntent final {
 public:
  SteadyIntent(const HandHabits& habits, std::uint64_t seed) : hand_(habits, Random(seed)) {
    hand_.stroke();
  }
  bool is_steady(std::int64_t time_ns) {
    const glm::dvec2 velocity_m_per_s(hand_.intent(time_ns).velocity_m_per_s);
    const bool moves = glm::length(velocity_m_per_s) > 0.0;
    const bool changed = glm::length(velocity_m_per_s - last_m_per_s_) > kSameSpeed_m_per_s;
    if (changed || !moves) since_ns_ = time_ns;
    last_m_per_s_ = velocity_m_per_s;
    return static_cast<double>(time_ns - since_ns_) * 1e-9 > kTransient_s;
  }

 private:
  VirtualHand
      hand_;  // moves as the one on the device does: its intent does not depend on the force
  glm::dvec2 last_m_per_s_{0.0};
  std::int64_t since_ns_ = 0;
};

}  // namespace

StrokeVibration stroke_vibration(const ForceModel& model, const RendererInputs& inputs,
                                 const FrictionStroke& stroke) {
  require_positive("FrictionStroke::rate_Hz", stroke.rate_Hz);
  require_positive("FrictionStroke::duration_s", stroke.duration_s);
  const auto renderer = make_renderer(model, inputs);
  VirtualHand hand(stroke.hand, Random(stroke.seed));
  SteadyIntent intent(stroke.hand, stroke.seed);
  SimulatedDevice device(hand, stroke.device);
  device.set_limits({.force_N = kForceLimit_N});
  hand.stroke();
  ButterworthFilter along(kFelt, stroke.rate_Hz);
  ButterworthFilter across(kFelt, stroke.rate_Hz);

  const std::int64_t period_ns = period_ns_of(stroke.rate_Hz);
  const auto ticks = std::llround(stroke.duration_s * stroke.rate_Hz);
  StrokeVibration vibration{};
  double squares_N2 = 0.0;
  double drag_N = 0.0;
  double normal_N = 0.0;
  std::int64_t steady = 0;
  std::int64_t last_ns = 0;
  for (std::int64_t tick = 1; tick <= ticks; ++tick) {
    const std::int64_t now_ns = tick * period_ns;
    const ProbeState probe = rounded_for_recording(device.read(now_ns).value());
    if (tick == 1) renderer->reset(probe);
    const double dt_s =
        tick == 1 ? 1.0 / stroke.rate_Hz : clamped_dt_s(last_ns, probe.time_ns, stroke.rate_Hz);
    last_ns = probe.time_ns;
    const Wrench wrench = renderer->tick(probe, dt_s).wrench;
    (void)device.push(wrench, dt_s);
    const double felt_N = std::hypot(along.next(wrench.force_N.x), across.next(wrench.force_N.y));
    const bool is_steady = intent.is_steady(now_ns);
    if (static_cast<double>(now_ns) * 1e-9 < stroke.settling_s) continue;
    if (!is_steady) {
      vibration.burst_N = std::max(vibration.burst_N, felt_N);
      continue;
    }
    ++steady;
    squares_N2 += felt_N * felt_N;
    drag_N += std::hypot(wrench.force_N.x, wrench.force_N.y);
    normal_N += wrench.force_N.z;
  }
  vibration.has_steady_part = steady > 0;
  if (steady > 0) vibration.steady_rms_N = std::sqrt(squares_N2 / static_cast<double>(steady));
  if (normal_N > 0.0) vibration.drag_share = drag_N / normal_N;
  return vibration;
}

}  // namespace asperity
