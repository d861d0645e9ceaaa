// Declares what the friction of a stimulus requires of a device near rest.

#pragma once

#include <optional>

#include "device/velocity_estimator.h"
#include "renderers/force/force_model.h"
#include "renderers/force/friction.h"
#include "stimuli/stimulus_description.h"

namespace asperity {

/// The friction of a stimulus under a normal force. Near rest, where its slope is greatest, it is a damper or a spring in
/// the loop (FrictionLaw::near_rest).
///
/// Bodies behind a virtual coupling have none: the tool's friction is integrated implicitly, and the device feels the
/// coupling.
struct PressedFriction {
  const FrictionLaw* law = nullptr;  ///< of friction_laws()
  FrictionSettings settings{};
  double force_N = 0.0;                 ///< F_n
  double greatest_speed_m_per_s = 0.0;  ///< the greatest v₀ that the model accepts

  FrictionNearRest near_rest(double period_s) const noexcept {
    return law->near_rest(settings, force_N, period_s);
  }
  /// With the law `rounded`: the normal force, and the v₀, at which the damper near rest has this strength and the rest is
  /// unchanged.
  double force_with_N(double damper_N_s_per_m) const noexcept {
    return damper_N_s_per_m * settings.speed_m_per_s / settings.coefficient;
  }
  double speed_with_m_per_s(double damper_N_s_per_m) const noexcept {
    return settings.coefficient * force_N / damper_N_s_per_m;
  }
};

/// The friction of a stimulus of this model under a normal force; nullopt without friction and behind a coupling.
/// Errors: as complete_values.
std::optional<PressedFriction> pressed_friction_of(const ForceModel& model,
                                                   const StimulusDescription& stimulus,
                                                   double force_N);

/// The known properties of a device that determine the friction it can render.
struct DampedResponse {
  static constexpr double kAssumedMass_kg = 0.05;

  std::optional<double> moving_mass_kg{};     ///< apparent; kAssumedMass_kg if it is unknown
  std::optional<double> damping_N_s_per_m{};  ///< along the surface
  double latency_s = 0.0;                     ///< 0 if it is unknown
  std::optional<VelocityWindow> velocity{};

  double mass_kg() const noexcept { return moving_mass_kg.value_or(kAssumedMass_kg); }
  /// Of the velocity in the loop: the latency plus the lag of the estimate.
  double delay_s(double period_s) const noexcept;
};

/// The damper on which the device begins to vibrate (sampled_loop.h): above it, while the hand is slower than about v₀,
/// which is the case at every reversal of a stroke, and at all speeds if B is much too large.
double steepest_damper_N_s_per_m(const DampedResponse& device, double period_s) noexcept;

/// The damping with which a device of this latency renders the spring and the damper of a contact near rest passively
/// (delayed_damping_N_s_per_m); 0 for a law without a spring.
double required_damping_N_s_per_m(const FrictionNearRest& friction, const DampedResponse& device,
                                  double period_s) noexcept;

/// The stiffest spring σ that the device's damping renders passively, with the lag and the damper of this contact. Not
/// positive if its damper alone requires more. The device's damping is known.
double stiffest_contact_N_per_m(const FrictionNearRest& friction, const DampedResponse& device,
                                double period_s) noexcept;

}  // namespace asperity
