// Implements the motion of a mass on a rendered surface, tick by tick.

#include "renderers/offline/contact_loss.h"

#include <cmath>
#include <cstdint>
#include <memory>

#include "device/refusal.h"
#include "renderers/servo/contact.h"

namespace asperity {

double share_out_of_contact(const ForceModel& model, const RendererInputs& inputs,
                            const PressedMass& stroke) {
  require_positive("PressedMass::mass_kg", stroke.mass_kg);
  require_not_negative("PressedMass::damping_N_s_per_m", stroke.damping_N_s_per_m);
  require_positive("PressedMass::force_N", stroke.force_N);
  require_positive("PressedMass::speed_m_per_s", stroke.speed_m_per_s);
  require_positive("PressedMass::rate_Hz", stroke.rate_Hz);
  require_positive("PressedMass::duration_s", stroke.duration_s);
  const double period_s = 1.0 / stroke.rate_Hz;
  const auto counted = std::llround(stroke.duration_s * stroke.rate_Hz);
  const std::int64_t dropped = counted / 2;
  const double length_m = static_cast<double>(counted + dropped) * period_s * stroke.speed_m_per_s;

  RendererInputs endless = inputs;
  endless.patch.tiling = Tiling::repeat;
  endless.patch.edge = PatchEdge::wall;  // never reached
  endless.patch.extent_m = 2.0 * (inputs.patch.extent_m + length_m);
  const std::unique_ptr<ForceRenderer> renderer = make_renderer(model, endless);

  // In one tick v approaches (F − P)/b by the fraction 1 − e^(−bT/m).
  const double mass_kg = stroke.mass_kg;
  const double relaxed = stroke.damping_N_s_per_m * period_s / mass_kg;
  const double gain_s = (relaxed > 0.0 ? -std::expm1(-relaxed) / relaxed : 1.0) * period_s;
  ProbeState probe{.position_m = inputs.patch.centre_m};
  probe.velocity_m_per_s.x = stroke.speed_m_per_s;
  probe.position_m.z -= stroke.force_N / inputs.material.stiffness_N_per_m;
  renderer->reset(probe);
  std::int64_t lost = 0;
  for (std::int64_t i = 0; i < dropped + counted; ++i) {
    const RenderedTick felt = renderer->tick(probe, period_s);
    if (i >= dropped && !is_in_contact(felt)) ++lost;
    const double pushed_N = felt.wrench.force_N.z - stroke.force_N;
    const double v_m_per_s = probe.velocity_m_per_s.z;
    const double drag_N = stroke.damping_N_s_per_m * v_m_per_s;
    probe.velocity_m_per_s.z += gain_s * (pushed_N - drag_N) / mass_kg;
    probe.position_m.z += 0.5 * period_s * (v_m_per_s + probe.velocity_m_per_s.z);
    probe.position_m.x += period_s * stroke.speed_m_per_s;
    probe.time_ns = std::llround(1e9 * period_s * static_cast<double>(i + 1));
  }
  return static_cast<double>(lost) / static_cast<double>(counted);
}

}  // namespace asperity
