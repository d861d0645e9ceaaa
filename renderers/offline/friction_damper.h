// Declares friction near rest as a damper in a sampled loop.

#pragma once

#include <optional>

#include "device/velocity_estimator.h"
#include "renderers/force/force_model.h"
#include "stimuli/stimulus_description.h"

namespace asperity {

/// The friction of a stimulus near rest: friction of the law `rounded`, F_f = −μ·F_n·v/√(v² + v₀²), is a damper of
/// B = μ·F_n/v₀ where v is small, where its slope is greatest. The other laws (force/friction.h) are not such a damper:
/// `bounded` keeps its slope below what the loop carries, `proxy` and `dahl` are springs near rest.
///
/// Bodies behind a virtual coupling have none: the tool's friction is integrated implicitly, and the device feels the
/// coupling.
struct FrictionDamper {
  double friction = 0.0;                ///< μ
  double force_N = 0.0;                 ///< F_n
  double speed_m_per_s = 0.0;           ///< v₀
  double greatest_speed_m_per_s = 0.0;  ///< the greatest v₀ that the model accepts

  double damper_N_s_per_m() const noexcept { return friction * force_N / speed_m_per_s; }
  /// The normal force, and the v₀, at which the damper has this strength and the rest is unchanged.
  double force_with_N(double damper_N_s_per_m) const noexcept {
    return damper_N_s_per_m * speed_m_per_s / friction;
  }
  double speed_with_m_per_s(double damper_N_s_per_m) const noexcept {
    return friction * force_N / damper_N_s_per_m;
  }
};

/// The damper of a stimulus of this model under a normal force; nullopt without friction, behind a coupling and with
/// a law other than `rounded`.
/// Errors: as complete_values.
std::optional<FrictionDamper> friction_damper_of(const ForceModel& model,
                                                 const StimulusDescription& stimulus,
                                                 double force_N);

/// The known properties of a device that determine the dampers it can render.
struct DampedResponse {
  static constexpr double kAssumedMass_kg = 0.05;

  std::optional<double> moving_mass_kg{};  ///< apparent; kAssumedMass_kg if it is unknown
  double latency_s = 0.0;                  ///< 0 if it is unknown
  std::optional<VelocityWindow> velocity{};

  double mass_kg() const noexcept { return moving_mass_kg.value_or(kAssumedMass_kg); }
  /// Of the velocity in the loop: the latency plus the lag of the estimate.
  double delay_s(double period_s) const noexcept;
};

/// The damper on which the device begins to vibrate (sampled_loop.h): above it, while the hand is slower than about v₀,
/// which is the case at every reversal of a stroke, and at all speeds if B is much too large.
double steepest_damper_N_s_per_m(const DampedResponse& device, double period_s) noexcept;

}  // namespace asperity
