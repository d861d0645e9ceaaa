// Declares the vibration that friction causes under a simulated hand that strokes to and fro.

#pragma once

#include <cstdint>

#include "device/simulated_device.h"
#include "device/virtual_hand.h"
#include "renderers/force/force_model.h"

namespace asperity {

/// A simulated hand on a simulated device, and the loop that renders to it.
struct FrictionStroke {
  SimulatedDeviceSettings device{};
  HandHabits hand{};
  double rate_Hz = 1000.0;
  double duration_s = 20.0;
  double settling_s = 3.0;  ///< of approach and first contact, which is dropped
  std::uint64_t seed = 1;
};

/// The force along the surface at 30 Hz and above, where textures are felt.
struct StrokeVibration {
  double burst_N = 0.0;       ///< the greatest one outside the steady parts: at a reversal
  double steady_rms_N = 0.0;  ///< in the steady parts of the strokes
  double drag_share = 0.0;    ///< mean drag over mean normal force in the steady parts
  bool has_steady_part = false;
};

/// Strokes over a stimulus in a closed loop: the hand yields to the force, and the device reads it with its latency, steps
/// and velocity estimate.
///
/// A high-pass of fourth order at 30 Hz passes F_x and F_y; the two together are judged. A part is steady from 0.1 s after
/// the intended speed has become constant, so that a reversal includes the hand's transients; all the rest is a reversal.
/// The sensor's readings are those of a recording (rounded_for_recording), as in ServoLoop.
///
/// Errors: as make_renderer, SimulatedDevice and VirtualHand; std::invalid_argument for a rate or duration that is not
/// positive.
StrokeVibration stroke_vibration(const ForceModel& model, const RendererInputs& inputs,
                                 const FrictionStroke& stroke);

}  // namespace asperity
