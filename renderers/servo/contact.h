// Defines when a probe is in contact with a surface, in one tick and over several.

#pragma once

#include <cstdint>

#include "analysis/signals/force_features.h"
#include "renderers/force/rendered_tick.h"
#include "renderers/servo/tick_record.h"

namespace asperity {

/// A probe is in contact with a surface in every tick in which the surface's renderer was called and computed a
/// penetration depth above 0. Every number and display of the program that depends on contact is derived from this:
///
///   is_in_contact            stored contact times, the time after which a surface is removed, the path in a recording,
///                            live displays, force features, missed deadlines in contact
///   measures_hand            the pressing force and the strokes by which an attempt is judged, the texture force
///
/// A contact that lasts continues over a gap that is short enough. How short depends on the question, and the three
/// answers have a name each:
///
///   kLift_s                  (force_features.h) what is felt as one touch: the crest of a texture or a lost sample
///                            releases the probe for a few ticks. For contacts as drawn and as force features.
///   kSkip_s                  what the hand does in one movement: a tool that skips over a coarse texture is in the air
///                            for longer than a crest, and the hand has not lifted it. For strokes and pressing force.
///   kUnbroken_ticks          what a filter may treat as evenly sampled: contact in every tick, and none lost between.
///                            For the spectrum of the texture force.
///
/// Real-time: the functions do not allocate, lock or throw.
inline bool is_in_contact(const RenderedTick& rendered) noexcept {
  return rendered.penetration_m > 0.0;
}

/// Whether the record is of a tick in which this presentation was rendered (`presentation`: Presentation::id).
inline bool is_rendered(const TickRecord& record, std::uint64_t presentation) noexcept {
  return record.presentation == presentation && record.has(TickFlag::presenting);
}

inline bool is_in_contact(const TickRecord& record) noexcept {
  return record.has(TickFlag::presenting) && record.penetration_m > 0.0;
}

/// With this presentation.
inline bool is_in_contact(const TickRecord& record, std::uint64_t presentation) noexcept {
  return record.presentation == presentation && is_in_contact(record);
}

/// In contact with a surface that is completely faded in. While it fades, the force that is sent is less than that of
/// the surface and does not measure how hard the hand presses.
inline bool measures_hand(const TickRecord& record) noexcept {
  return is_in_contact(record) && record.gain >= 1.0;
}

/// The longest time without contact after which the hand has not lifted.
inline constexpr double kSkip_s = 0.1;

/// Two records that are at least this many periods apart are not consecutive.
inline constexpr double kUnbroken_ticks = 2.5;

}  // namespace asperity
