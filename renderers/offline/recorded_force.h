// What a recorded hand was given: the force it felt, and the texture's share of it.

#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "analysis/force_features.h"
#include "renderers/force_model.h"
#include "renderers/tick_record.h"

namespace asperity {

/// One surface among the records of an attempt.
struct RecordedSurfaceSpan {
  std::span<const TickRecord> records{};
  std::uint64_t presentation = 0;  ///< Presentation::id of the surface
  double rate_Hz = 1000.0;
};

/// Features of the force that the device was sent (ramp and limits included) while the probe
/// touched the surface. Normal: +z. Lateral: along the motion, positive against it.
ForceFeatures recorded_force_features(const RecordedSurfaceSpan& surface);

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
