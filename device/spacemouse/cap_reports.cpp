// The reports of a SpaceMouse: how far its cap is pushed and turned, and which buttons are down.

#include "device/spacemouse/cap_reports.h"

#include <algorithm>
#include <cstddef>

namespace asperity::spacemouse {
namespace {

constexpr std::uint8_t kPushOrBoth = 1;
constexpr std::uint8_t kTurn = 2;
constexpr std::uint8_t kButtons = 3;
constexpr std::size_t kThreeAxes_bytes = 7;
constexpr std::size_t kSixAxes_bytes = 13;
constexpr std::size_t kFewestButtons_bytes = 2;
constexpr std::size_t kMostButtons_bytes = 7;
constexpr double kFullDeflection = 350.0;

double share_at(std::span<const std::uint8_t> report, std::size_t byte) noexcept {
  const auto bits = static_cast<std::uint16_t>(report[byte] | report[byte + 1] << 8U);
  return std::clamp(static_cast<std::int16_t>(bits) / kFullDeflection, -1.0, 1.0);
}

// Three words from `byte` on, in our axes.
glm::dvec3 shares_at(std::span<const std::uint8_t> report, std::size_t byte) noexcept {
  return {share_at(report, byte), -share_at(report, byte + 2), -share_at(report, byte + 4)};
}

}  // namespace

CapReader::Told CapReader::take(std::span<const std::uint8_t> report) noexcept {
  if (report.empty()) return Told::nothing;
  const std::size_t size = report.size();
  switch (report[0]) {
    case kPushOrBoth:
      if (size == kSixAxes_bytes) {
        tells_both_ = true;
        cap_.turn = shares_at(report, 7);
      } else if (size != kThreeAxes_bytes || tells_both_) {
        return refused();
      }
      cap_.push = shares_at(report, 1);
      return Told::motion;
    case kTurn:
      if (size != kThreeAxes_bytes || tells_both_) return refused();
      cap_.turn = shares_at(report, 1);
      return Told::motion;
    case kButtons: {
      if (size < kFewestButtons_bytes || size > kMostButtons_bytes) return refused();
      std::uint32_t buttons = 0;
      for (std::size_t i = 1; i < std::min(size, std::size_t{5}); ++i) {
        buttons |= std::uint32_t{report[i]} << (8 * (i - 1));
      }
      cap_.buttons = buttons;
      return Told::buttons;
    }
    default:
      return Told::nothing;
  }
}

CapReader::Told CapReader::refused() noexcept {
  ++malformed_;
  return Told::nothing;
}

void CapReader::reset() noexcept {
  cap_ = {};
  tells_both_ = false;
}

}  // namespace asperity::spacemouse
