// Declares the proportion of a stroke in which a held mass loses contact with a surface.

#pragma once

#include "device/simulated_device.h"
#include "device/virtual_hand.h"
#include "renderers/force/force_model.h"

namespace asperity {

/// Strokes to and fro by a hand that holds the mass of a device.
struct HeldStrokes {
  HandMechanics hand{};  ///< mass and damping of the device and the hand that holds it
  HandHabits habits{};
  double rate_Hz = 1000.0;  ///< of the loop that renders the surface
};

/// The proportion of eight strokes, from rest to rest, without contact:
///
///   m·ẍ = k_h·(x_h − x) + b·(ẋ_h − ẋ) + F_x,    the same along y
///   m·z̈ = F_z − P − b_z·ż
///
/// x_h(t) is the motion of the hand (VirtualHand), k_h the stiffness of its hold, b and b_z the damping along and across the
/// surface, P the force with which it presses: the mass is that of SimulatedDevice. F is the force of the model's own
/// renderer, at the rate of its loop, within the usual ForceLimits and held constant between ticks. The patch's border is
/// removed, and a texture that is not repeated continues mirrored. The strokes vary in
/// speed and force as those of a session, and count from 0.5 s after the touch-down.
///
/// Contact is lost where the surface descends faster than the mass follows: on a stiff sinusoid of amplitude A, if
/// A·√((m·ω²)² + (b_z·ω)²) > P with ω = 2πv/λ; a soft one (k well below m·ω²) yields instead.
///
/// The motion along the surface is part of the model because a force that turns with the relief stops it. On the slope s of
/// a grating, a force along its normal has the component s·F_z against the stroke, up to 2πA/λ·P. The hold yields by s·P/k_h:
/// for A 0.5 mm, λ 2 mm, 1 N and 300 N/m by 5 mm, more than two wavelengths. The tip therefore rests in front of a ridge, in
/// contact, until the hand has moved on, and crosses it in a jump. A tip that is guided along the surface at the speed of the
/// hand has no such rests and loses contact several times as long. A force of fixed direction has no such component.
///
/// Limits: a hand adds mass and damping to those of a device, and its hold is assumed. Near the onset of the loss a single
/// stroke that happens to be fast, or light, changes the result by about 0.01.
///
/// Cost: at most 2.5 s and eight strokes of the loop, some 12 s at 60 mm/s and 60 mm.
///
/// Errors: std::invalid_argument for a rate that is not positive, in the cases of SimulatedDevice and VirtualHand, and in
/// those of the model.
double share_out_of_contact(const ForceModel& model, const RendererInputs& inputs,
                            const HeldStrokes& strokes);

}  // namespace asperity
