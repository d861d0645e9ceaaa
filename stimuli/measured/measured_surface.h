// Declares a measured surface and the decoding of the files in which instruments store it.

#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// X3P (ISO 25178-72), SUR (Digital Surf), GWY (Gwyddion), and greyscale TIFF of 32-bit floating-point numbers.
enum class SurfaceFormat { x3p, sur, gwy, tiff };

/// The format's name: "X3P", "SUR" and so on.
std::string_view name_of(SurfaceFormat format) noexcept;

/// The greatest accepted number of points; each side has at most kLargestPictureSide, because the height field is a picture.
inline constexpr std::size_t kMostSurfacePoints = std::size_t{1} << 26;

/// Heights that an instrument measured, on a rectangular grid.
///
/// Units: metres. The heights are stored row by row, the first row of the file first; a point that was not measured is NaN,
/// all others are finite.
struct MeasuredSurface {
  SurfaceFormat format = SurfaceFormat::x3p;
  std::size_t rows = 0;
  std::size_t columns = 0;
  double pitch_x_m = 0.0;  ///< distance between neighbouring points of a row
  double pitch_y_m = 0.0;  ///< distance between neighbouring rows
  std::vector<double> heights_m{};
  bool has_further_pages = false;  ///< of a TIFF, of which the first is read
  std::string
      channel{};  ///< of a GWY file, its number and title: "0 (Topography)"; otherwise empty
};

/// What a file does not state.
struct SurfaceReading {
  std::optional<double> width_m{};        ///< of a TIFF: columns times the distance between them
  std::optional<double> height_unit_m{};  ///< of a TIFF: the height of the stored number 1
  std::optional<int>
      channel{};  ///< of a GWY file; without it, the first channel whose heights are in metres
};

/// The format of a measured surface, from the first bytes of the file; nullopt for every other file, also for a picture.
///
/// Errors: std::invalid_argument that begins with `name`, for a TIFF with a damaged header.
std::optional<SurfaceFormat> surface_format_of(std::span<const std::byte> bytes,
                                               const std::string& name);

/// Decodes a measured surface. Before memory is allocated for the points, their number is compared with the bounds and with
/// the size of the file.
///
/// Errors: std::invalid_argument that begins with `name` and the place (the offset of a byte, or the line of an element), for a
/// file that is damaged, truncated or not supported, for fewer than 2 × 2 or too many points, for a distance of points that is
/// not from 1 nm to 1 mm, for heights beyond ±1 m, and for a `reading` that does not apply to the format or lacks a value.
MeasuredSurface decode_surface(std::span<const std::byte> bytes, const SurfaceReading& reading,
                               const std::string& name);

}  // namespace asperity
