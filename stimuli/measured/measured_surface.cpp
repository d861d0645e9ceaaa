// Implements the choice of the decoder of a measured surface, and the checks that all formats have in common.

#include "stimuli/measured/measured_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "analysis/numbers/number_text.h"
#include "analysis/words/phrased_error.h"
#include "stimuli/measured/surface_decoding.h"
#include "stimuli/pictures/float_tiff.h"
#include "stimuli/pictures/photograph.h"

namespace asperity {

namespace {

constexpr double kLeastPitch_m = 1e-9;
constexpr double kGreatestPitch_m =
    1e-3;  // a wave has at least two points, a fingertip or a tip is wider
constexpr double kGreatestHeight_m = 1.0;  // of a height field (docs/formats/height_field.md)

void require_pitch(double pitch_m, const std::string& axis, const std::string& name) {
  if (pitch_m >= kLeastPitch_m && pitch_m <= kGreatestPitch_m) return;
  throw PhrasedRefusal(
      phrase("Stimuli",
             "%1: the distance between points along %2 is %3 m; from %4 to %5 m are "
             "possible. Correct the unit or the distance in the file.")
          .with(name, axis, number_text(pitch_m), number_text(kLeastPitch_m),
                number_text(kGreatestPitch_m)));
}

/// Infinite numbers are missing points as well. A surface without a point is refused where its relief is made.
void check_heights(MeasuredSurface& surface, const std::string& name) {
  double lowest_m = std::numeric_limits<double>::infinity();
  double highest_m = -lowest_m;
  for (std::size_t i = 0; i < surface.heights_m.size(); ++i) {
    double& height_m = surface.heights_m[i];
    if (!std::isfinite(height_m)) {
      height_m = std::numeric_limits<double>::quiet_NaN();
    } else if (std::abs(height_m) > kGreatestHeight_m) {
      throw PhrasedRefusal(
          phrase("Stimuli",
                 "%1: the height of the point %2 of the row %3 is %4 m; from -1 to "
                 "1 m are possible. Correct the unit of the heights.")
              .with(name, std::to_string(i % surface.columns + 1),
                    std::to_string(i / surface.columns + 1), number_text(height_m)));
    } else {
      lowest_m = std::min(lowest_m, height_m);
      highest_m = std::max(highest_m, height_m);
    }
  }
  if (lowest_m == highest_m) {
    throw PhrasedRefusal(
        phrase("Stimuli",
               "%1: every height is %2 m, so that there is no relief to feel. "
               "Export the heights of the surface, not a mask or an empty channel.")
            .with(name, number_text(lowest_m)));
  }
}

void refuse_option(const std::string& name, SurfaceFormat format, const char* what) {
  throw std::invalid_argument(name + " is a " + std::string(name_of(format)) + " file, which " +
                              what);
}

/// Errors: a value in `reading` that the format states itself.
void check_reading(const SurfaceReading& reading, SurfaceFormat format, const std::string& name) {
  if (format != SurfaceFormat::tiff && reading.width_m) {
    refuse_option(name, format, "states its width; leave out --width-m.");
  }
  if (format != SurfaceFormat::tiff && reading.height_unit_m) {
    refuse_option(name, format, "states the unit of its heights; leave out --height-unit-m.");
  }
  if (format != SurfaceFormat::gwy && reading.channel) {
    refuse_option(name, format, "has no channels; leave out --channel.");
  }
}

MeasuredSurface decode(std::span<const std::byte> bytes, SurfaceFormat format,
                       const SurfaceReading& reading, const std::string& name) {
  switch (format) {
    case SurfaceFormat::x3p:
      return decode_x3p(bytes, name);
    case SurfaceFormat::sur:
      return decode_sur(bytes, name);
    case SurfaceFormat::gwy:
      return decode_gwy(bytes, reading, name);
    case SurfaceFormat::tiff:
      return decode_tiff_surface(bytes, reading, name);
  }
  throw std::logic_error("a format without a decoder");
}

}  // namespace

std::string_view name_of(SurfaceFormat format) noexcept {
  switch (format) {
    case SurfaceFormat::x3p:
      return "X3P";
    case SurfaceFormat::sur:
      return "SUR";
    case SurfaceFormat::gwy:
      return "GWY";
    case SurfaceFormat::tiff:
      return "TIFF";
  }
  return "";
}

Phrase points_problem(std::uint64_t columns, std::uint64_t rows) {
  const bool possible = columns >= 2 && rows >= 2 && columns <= kLargestPictureSide &&
                        rows <= kLargestPictureSide && columns * rows <= kMostSurfacePoints;
  if (possible) return {};
  return phrase(
             "Stimuli",
             "the surface has %1 by %2 points; from 2 to %3 per side and at most %4 in total are "
             "possible. Crop it or reduce its resolution")
      .with(std::to_string(columns), std::to_string(rows), std::to_string(kLargestPictureSide),
            std::to_string(kMostSurfacePoints));
}

std::optional<SurfaceFormat> surface_format_of(std::span<const std::byte> bytes,
                                               const std::string& name) {
  const SurfaceBytes file(bytes, name);
  if (file.begins_with("PK\x03\x04")) return SurfaceFormat::x3p;
  if (file.begins_with("DIGITAL SURF") || file.begins_with("DSCOMPRESSED")) {
    return SurfaceFormat::sur;
  }
  if (file.begins_with("GWYP")) return SurfaceFormat::gwy;
  if (is_float_tiff(bytes, name)) return SurfaceFormat::tiff;
  return std::nullopt;
}

MeasuredSurface decode_surface(std::span<const std::byte> bytes, const SurfaceReading& reading,
                               const std::string& name) {
  const std::optional<SurfaceFormat> format = surface_format_of(bytes, name);
  if (!format) {
    throw std::invalid_argument(
        name +
        " is not a measured surface in a supported format; save it as X3P, SUR, GWY or TIFF with "
        "32-bit floating-point numbers.");
  }
  check_reading(reading, *format, name);
  MeasuredSurface surface = decode(bytes, *format, reading, name);
  surface.format = *format;
  require_pitch(surface.pitch_x_m, "x", name);
  require_pitch(surface.pitch_y_m, "y", name);
  check_heights(surface, name);
  return surface;
}

}  // namespace asperity
