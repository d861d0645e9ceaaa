// The frames that a Falcon's firmware speaks: sixteen bytes out, sixteen bytes in.

#include "device/falcon/falcon_frame.h"

namespace asperity::falcon {
namespace {

constexpr std::uint8_t kOpening = '<';
constexpr std::uint8_t kClosing = '>';
constexpr std::uint8_t kOffset = 'A';
constexpr std::size_t kStateByte = 13;

// The state's seven bits are not a nibble.
constexpr std::uint8_t kLargestState = 0x7f;

}  // namespace

Frame frame_of(const Command& command) noexcept {
  Frame frame{};
  frame.fill(kOffset);
  frame.front() = kOpening;
  frame.back() = kClosing;
  for (std::size_t motor = 0; motor < 3; ++motor) {
    const auto word = static_cast<std::uint16_t>(command.motor_words[motor]);
    for (std::size_t nibble = 0; nibble < 4; ++nibble) {
      frame[1 + 4 * motor + nibble] =
          static_cast<std::uint8_t>(kOffset + ((word >> (4 * nibble)) & 0xfU));
    }
  }
  frame[kStateByte] = static_cast<std::uint8_t>(kOffset + static_cast<std::uint8_t>(command.lamp) +
                                                (command.is_homing ? 1 : 0));
  return frame;
}

std::optional<Answer> answer_in(std::span<const std::uint8_t, kFrame_bytes> frame) noexcept {
  if (frame.front() != kOpening || frame.back() != kClosing) return {};
  Answer answer{};
  for (std::size_t motor = 0; motor < 3; ++motor) {
    unsigned word = 0;
    for (std::size_t nibble = 0; nibble < 4; ++nibble) {
      const unsigned value = frame[1 + 4 * motor + nibble] - unsigned{kOffset};
      if (value > 0xfU) return {};  // below the offset it wrapped
      word |= value << (4 * nibble);
    }
    answer.counts[motor] = static_cast<std::int16_t>(static_cast<std::uint16_t>(word));
  }
  const unsigned state = frame[kStateByte] - unsigned{kOffset};
  if (state > kLargestState) return {};
  answer.buttons = static_cast<std::uint8_t>(state & 0xfU);
  answer.homed_motors = static_cast<std::uint8_t>(state >> 4U);
  return answer;
}

std::optional<Answer> FrameReader::take(std::uint8_t byte) noexcept {
  // 'A' and more fills a frame: an opening bracket is always where one begins.
  if (byte == kOpening) {
    if (filled_ > 0) ++malformed_;
    frame_[0] = kOpening;
    filled_ = 1;
    return {};
  }
  if (filled_ == 0) return {};
  frame_[filled_++] = byte;
  if (filled_ < kFrame_bytes) return {};
  filled_ = 0;
  const std::optional<Answer> answer = answer_in(frame_);
  if (!answer) ++malformed_;
  return answer;
}

}  // namespace asperity::falcon
