// The reports of a SpaceMouse: how far its cap is pushed and turned, and which buttons are down.

#pragma once

#include <cstdint>
#include <span>

#include <glm/vec3.hpp>

namespace asperity::spacemouse {

/// The cap and the buttons beside it.
///
/// Frame: Asperity's; x to the right, y away from the hand, z up. Shares of the full deflection, −1 to 1.
struct Cap {
  glm::dvec3 push{0.0};
  glm::dvec3 turn{0.0};  ///< about the same axes, by the right-hand rule
  std::uint32_t buttons = 0;
};

/// Reads reports as they come; what they do not tell stays as it was.
///
/// A report is its number and little-endian words of sixteen bits:
///
///   1: x y z            the push, of models that tell it apart from the turn; 7 bytes
///   2: rx ry rz         the turn, of the same models; 7 bytes
///   1: x y z rx ry rz   both, of newer models; 13 bytes
///   3: buttons          bit 0 the first of them; 2 to 7 bytes
///
/// A deflection of 350 is full in the descriptors of the devices; what is beyond counts as full. Axes are those of
/// [USB 1998]: x from left to right, y from far to near, z from high to low, turns by the right-hand rule about them.
/// Ours are (x, −y, −z), half a turn about x, and turns change alike.
///
/// Other numbers (the battery is 23) are passed over. What has a number above and none of its lengths changes nothing
/// and is counted; once both came in one report, half of one is such.
///
/// Real-time: does not allocate, lock or throw.
///
/// [USB 1998] HID Usage Tables 1.1, section 4.2. Numbers, layouts and the 350 are those that users of the devices have
/// written down (docs/devices.md); no unit was at hand.
class CapReader final {
 public:
  enum class Told { nothing, motion, buttons };

  /// What `report`, its number first, told.
  Told take(std::span<const std::uint8_t> report) noexcept;
  const Cap& cap() const noexcept { return cap_; }
  /// Reports that were cut short or are too long, since construction.
  std::uint64_t malformed() const noexcept { return malformed_; }
  /// The cap is at rest, and the next report may be another device's.
  void reset() noexcept;

 private:
  Told refused() noexcept;

  Cap cap_{};
  bool tells_both_ = false;
  std::uint64_t malformed_ = 0;
};

}  // namespace asperity::spacemouse
