// Declares the strokes in the recording of an attempt as a recorded texture.

#pragma once

#include <cstdint>
#include <span>

#include "renderers/recordings/texture_recording.h"
#include "renderers/servo/tick_record.h"

namespace asperity {

/// The component of the force that carries a texture.
enum class TextureComponent { motion, normal };

/// The part of a recording from which strokes are taken.
struct RecordedHand {
  std::span<const TickRecord> records{};
  std::uint64_t presentation = 0;  ///< Presentation::id of the surface
  double rate_Hz = 1000.0;
  TextureComponent component = TextureComponent::motion;
};

/// The force that was sent to the device while the hand stroked a surface: its component against the motion, or the
/// normal one. A stroke is 0.25 s of uninterrupted contact at full gain in one direction, within 30°, at 20 mm/s and
/// faster; the rest is left out. Several of them follow each other in a long stroke, each with its own mean speed.
TextureRecording strokes_of_hand(const RecordedHand& hand);

}  // namespace asperity
