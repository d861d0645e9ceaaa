// The frames that a Falcon's firmware speaks: sixteen bytes out, sixteen bytes in.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace asperity::falcon {

inline constexpr std::size_t kFrame_bytes = 16;
using Frame = std::array<std::uint8_t, kFrame_bytes>;

/// The lamps at the front; bits of a frame's thirteenth byte.
enum class Lamp : std::uint8_t { none = 0, green = 2, blue = 4, red = 8 };

/// What is told to the device. Words are in the motors' own units.
struct Command {
  std::array<std::int16_t, 3> motor_words{};
  Lamp lamp = Lamp::none;
  bool is_homing = false;  ///< take the end of travel as the encoders' zero when it is reached
};

/// What the device tells.
struct Answer {
  std::array<std::int16_t, 3> counts{};
  std::uint8_t buttons = 0;       ///< bits 0 to 3
  std::uint8_t homed_motors = 0;  ///< bits 0 to 2
  bool is_homed() const noexcept { return homed_motors == 0b111; }
};

/// A frame is '<', three words of four nibbles each, the least significant first, a byte of lamps and
/// homing, a byte that is always zero, '>'. What lies between the brackets has 0x41 ('A') added.
Frame frame_of(const Command& command) noexcept;

/// Nothing for sixteen bytes that are no frame: brackets, or a nibble that is none.
std::optional<Answer> answer_in(std::span<const std::uint8_t, kFrame_bytes> frame) noexcept;

/// Finds frames in bytes as they come: halves of frames, or noise before one.
///
/// Real-time: does not allocate, lock or throw.
class FrameReader final {
 public:
  /// The answer that `byte` completes.
  std::optional<Answer> take(std::uint8_t byte) noexcept;
  /// Sequences that began as a frame and were none, since construction.
  std::uint64_t malformed() const noexcept { return malformed_; }
  void reset() noexcept { filled_ = 0; }

 private:
  Frame frame_{};
  std::size_t filled_ = 0;
  std::uint64_t malformed_ = 0;
};

}  // namespace asperity::falcon
