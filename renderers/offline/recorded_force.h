// What a recorded hand was given: the force it felt, and the texture's share of it.

#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "analysis/force_features.h"
#include "renderers/force/force_model.h"
#include "renderers/servo/tick_record.h"

namespace asperity {

/// One surface among the records of an attempt.
struct RecordedSurfaceSpan {
  std::span<const TickRecord> records{};
  std::uint64_t presentation = 0;  ///< Presentation::id of the surface
  double rate_Hz = 1000.0;
};

/// Features of the force that the device was sent (ramp and limits included) while the probe
/// touched the surface. Normal: +z. Lateral: along the motion, positive against it. With
/// recorded_shaking_m_per_s2, where there is one.
ForceFeatures recorded_force_features(const RecordedSurfaceSpan& surface);

/// RMS acceleration of a held tool (FeltRoughness, its usual hand) that is given the force which the
/// device was sent while the probe touched the surface; nothing where no contact is long enough. It is
/// no share of anything: whoever presses harder, or draws faster over the same waves, feels another one.
///
/// The tool's x goes with the hand: along the motion, its y to the left of it. So Coulomb friction is one
/// force on the way there and back, and a turn of the hand does not count as texture. Of each contact
/// the beginning is left out (beginning_s), and the last 0.1 s, in which the hand lifts; a tool that
/// leaves the surface for less than kLift_s has not been lifted. Mean squares of several contacts are
/// pooled.
std::optional<double> recorded_shaking_m_per_s2(const RecordedSurfaceSpan& surface);

/// A band of frequencies, both borders included.
struct TextureForceBand {
  double low_Hz = 5.0;
  double high_Hz = 500.0;
};

/// RMS of the texture force along the path of a recorded hand: the rendered force minus that of the
/// same model without texture along the same path, within the band, over stretches of unbroken
/// contact at full gain that last a quarter of a second or more; nothing when there is none.
///
/// Friction stays in both forces. On the prescribed path of `texture_force_rms_N` it is constant
/// but for what the texture makes of it, and it makes no difference there; a hand that turns round
/// would count it as texture.
///
/// Errors: std::invalid_argument for inputs that the model refuses.
std::optional<double> recorded_texture_force_rms_N(const ForceModel& model,
                                                   const RendererInputs& inputs,
                                                   const RecordedSurfaceSpan& surface,
                                                   const TextureForceBand& band);

}  // namespace asperity
