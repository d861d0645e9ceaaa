// Declares features of recorded forces: the force on the hand and the texture force in it.

#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "analysis/signals/force_features.h"
#include "renderers/force/force_model.h"
#include "renderers/servo/tick_record.h"

namespace asperity {

/// The records of one surface of an attempt.
struct RecordedSurfaceSpan {
  std::span<const TickRecord> records{};
  std::uint64_t presentation = 0;  ///< Presentation::id of the surface
  double rate_Hz = 1000.0;
};

/// The features of the force that was sent to the device (ramp and limits included) while the probe touched the
/// surface. Normal: +z. Lateral: along the motion, positive against it. Includes recorded_shaking_m_per_s2 if it
/// exists. The compliance is that of the force as sent: a force that was limited makes a surface softer.
ForceFeatures recorded_force_features(const RecordedSurfaceSpan& surface);

/// The RMS acceleration of a held tool (FeltRoughness with its default hand) under the force that was sent to the
/// device while the probe touched the surface; nullopt if no contact is long enough. It is an absolute quantity: it
/// changes with the normal force and with the speed over the same waves.
///
/// The tool's frame moves with the hand: x is along the motion, y to the left of it. Coulomb friction is therefore the
/// same force in both directions, and a reversal of the hand does not count as texture. The beginning of each contact
/// is left out (beginning_s), and the last 0.1 s, in which the hand lifts; an interruption of contact for less than
/// kLift_s is not a lift. Mean squares of several contacts are pooled.
std::optional<double> recorded_shaking_m_per_s2(const RecordedSurfaceSpan& surface);

/// A band of frequencies, both limits included.
struct TextureForceBand {
  double low_Hz = 5.0;
  double high_Hz = 500.0;

  friend bool operator==(const TextureForceBand&, const TextureForceBand&) = default;
};

/// The records of the ticks in which the surface was rendered, each of its entries with
/// TickFlag::first_of_presentation: where the record before belongs to another surface. Side by side
/// (adjacent_patches.h), the renderer of a patch is reset at each entry, and the recording has the flag only where the
/// renderer of the workspace was reset. A model that depends on past samples repeats its force only if it is reset at
/// the same ticks.
///
/// Limits: inside a patch, where its weight is 1, a replay of its model equals the rendered force, except for the contact of the
/// friction, which the patch takes over from the flat surface, and for the first tick of an entry, which lasts one period.
std::vector<TickRecord> records_as_felt(const RecordedSurfaceSpan& surface);

/// The records of a surface and what the same model computes without texture along the same path.
struct RecordedTexture {
  std::vector<TickRecord> felt{};  ///< records_as_felt
  std::vector<RenderedTick>
      plate{};  ///< without texture, with the friction of the surface; one for each record
  double rate_Hz = 1000.0;
};

/// Errors: std::invalid_argument for inputs that the model rejects.
RecordedTexture recorded_texture(const ForceModel& model, const RendererInputs& inputs,
                                 const RecordedSurfaceSpan& surface);

/// The RMS of the texture force along the path of a recorded hand: the rendered force minus that of the plate, within
/// the band, over stretches of uninterrupted contact at full gain that last a quarter of a second or more; nullopt if there
/// is none.
///
/// Friction is included in both forces. On the prescribed path of `texture_force_rms_N` it is constant except for the
/// effect of the texture on it and has no influence; with a hand that reverses its direction it would count as texture.
std::optional<double> recorded_texture_force_rms_N(const RecordedTexture& texture,
                                                   const TextureForceBand& band);

}  // namespace asperity
