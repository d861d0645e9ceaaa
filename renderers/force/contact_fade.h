// Declares the fading of a texture over the first part of the depth of a contact.

#pragma once

#include "renderers/force/smoothstep.h"

namespace asperity {

/// The depth w₀ over which a texture fades in. On 500 N/m the plate pushes with 50 mN there, and a hand that comes down at
/// 50 mm/s takes 2 ms to it. A stroke at a force of 1 N stays deeper on a surface of up to 10 kN/m.
inline constexpr double kContactFade_m = 1e-4;

/// s(w/w₀), the factor of a force that the law of a model does not take from the depth w: without it the motors would
/// receive the whole of that force in the tick in which contact begins. The plate itself needs no factor, as it begins at 0.
///
/// In a tick T a hand that comes down at v adds at most 1.5·v·T/w₀ of the force: three quarters at 50 mm/s and 1 kHz.
///
/// Real-time: no allocation, no exceptions.
inline double contact_fade(double depth_m) noexcept { return smoothstep(depth_m / kContactFade_m); }

}  // namespace asperity
