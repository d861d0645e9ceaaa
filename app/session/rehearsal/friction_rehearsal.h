// Friction near rest against a device: on which stimuli a hand will feel the loop vibrate.

#pragma once

#include <optional>
#include <vector>

#include "app/session/rehearsal/rehearsal.h"
#include "device/velocity_estimator.h"
#include "protocols/design/protocol.h"
#include "renderers/force/force_model.h"

namespace asperity {

/// How a device answers to a damper, as far as it is known.
struct DampedResponse {
  /// Its apparent mass [kg]. Where it is unknown 50 g are assumed, and the warning states so.
  std::optional<double> moving_mass_kg{};
  double latency_s = 0.0;  ///< 0 where it is unknown
  std::optional<VelocityWindow> velocity{};
};

/// A warning "friction_damping" for every stimulus of the plan whose friction would make the loop vibrate.
///
/// The friction of every force model, F_f = −μ·F_n·v/√(v² + v₀²), is a damper of B = μ·F_n/v₀ near rest, where its slope
/// is greatest. It is rendered from a sampled velocity, so it has to stay below `steepest_damper_N_s_per_m`
/// (sampled_loop.h), with T of the protocol's rate and τ the latency plus the lag of the estimated velocity. Above it the
/// loop vibrates while the hand is slower than about v₀: at every reversal of a stroke, and at all speeds where B is much
/// too large.
///
/// F_n is the greatest force that the exploration accepts, or else the one that it aims at. The warning names v₀ and F_n
/// with which the loop would not vibrate, v₀ as far as the model accepts it. Bodies behind a virtual coupling are
/// not compared: the tool's friction is integrated implicitly, and the device feels the coupling.
std::vector<RehearsalWarning> friction_warnings(const Protocol& protocol,
                                                const ModelRegistry& models,
                                                const DampedResponse& device);

}  // namespace asperity
