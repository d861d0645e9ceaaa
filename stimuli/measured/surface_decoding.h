// Declares what the decoders of measured surfaces share, and one decoder for each format.

#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "analysis/words/phrase.h"
#include "stimuli/measured/measured_surface.h"

namespace asperity {

/// Little-endian numbers and texts at offsets of a file; every reading beyond its end is refused.
///
/// Errors: std::invalid_argument, "NAME: byte OFFSET: PROBLEM".
class SurfaceBytes final {
 public:
  SurfaceBytes(std::span<const std::byte> bytes, const std::string& name)
      : bytes_(bytes), name_(name) {}

  [[noreturn]] void refuse(std::size_t at, const Phrase& problem) const;

  std::size_t size() const noexcept { return bytes_.size(); }
  bool begins_with(std::string_view text) const noexcept;
  std::span<const std::byte> part(std::size_t at, std::size_t count) const;
  /// `count` bytes as text.
  std::string_view text(std::size_t at, std::size_t count) const;
  /// The text up to the next zero byte, which is not a part of it.
  std::string_view text_until_zero(std::size_t at) const;

  std::uint64_t whole(std::size_t at, std::size_t width) const;
  std::uint16_t u16(std::size_t at) const { return static_cast<std::uint16_t>(whole(at, 2)); }
  std::uint32_t u32(std::size_t at) const { return static_cast<std::uint32_t>(whole(at, 4)); }
  std::int16_t i16(std::size_t at) const { return static_cast<std::int16_t>(u16(at)); }
  std::int32_t i32(std::size_t at) const { return static_cast<std::int32_t>(u32(at)); }
  double f32(std::size_t at) const { return static_cast<double>(std::bit_cast<float>(u32(at))); }
  double f64(std::size_t at) const { return std::bit_cast<double>(whole(at, 8)); }

 private:
  std::span<const std::byte> bytes_;
  const std::string& name_;
};

/// Why a surface cannot have so many points, as the problem of a refusal; empty if it can.
Phrase points_problem(std::uint64_t columns, std::uint64_t rows);

/// Whether `stored` bytes of compressed data can contain `expanded` bytes: no supported compression exceeds a ratio of 2000.
constexpr bool can_expand_to(std::uint64_t stored, std::uint64_t expanded) noexcept {
  return expanded / 2000 <= stored;
}

MeasuredSurface decode_x3p(std::span<const std::byte> bytes, const std::string& name);
MeasuredSurface decode_sur(std::span<const std::byte> bytes, const std::string& name);
/// Uses `reading.channel`.
MeasuredSurface decode_gwy(std::span<const std::byte> bytes, const SurfaceReading& reading,
                           const std::string& name);
/// Uses `reading.width_m` and `reading.height_unit_m`.
MeasuredSurface decode_tiff_surface(std::span<const std::byte> bytes, const SurfaceReading& reading,
                                    const std::string& name);

}  // namespace asperity
