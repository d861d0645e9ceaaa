// Implements the decoding of SUR files (Digital Surf), plain and compressed.

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <vector>

#include <zlib.h>

#include "stimuli/measured/surface_decoding.h"

namespace asperity {

namespace {

// Offsets of the header.
constexpr std::size_t kHeaderBytes = 512;
constexpr std::size_t kByteOrder = 12;
constexpr std::size_t kObjectType = 18;
constexpr std::size_t kSpecialPoints = 86;
constexpr std::size_t kBitsPerPoint = 98;
constexpr std::size_t kLeastHeight = 100;
constexpr std::size_t kColumns = 108;
constexpr std::size_t kRows = 112;
constexpr std::size_t kSpacings = 120;
constexpr std::size_t kSpacingUnits = 180;
constexpr std::size_t kUnitBytes = 16;
constexpr std::size_t kInversion = 290;
constexpr std::size_t kCommentBytes = 334;
constexpr std::size_t kPrivateBytes = 336;
constexpr std::size_t kHeightOffset = 474;

// Gwyddion writes surfaces as objects of type 1.
constexpr int kProfile = 1;
constexpr int kSurface = 2;

/// The length of the unit that is written at `at`.
double unit_in_m(const SurfaceBytes& file, std::size_t at) {
  std::string_view unit = file.text(at, kUnitBytes);
  unit = unit.substr(0, unit.find('\0'));
  unit = unit.substr(0, unit.find_last_not_of(' ') + 1);
  if (unit == "m") return 1.0;
  if (unit == "mm") return 1e-3;
  // The micro sign of Latin-1, of the code pages 437 and 850, of UTF-8, and the Greek letter of UTF-8.
  if (unit == "\xB5m" || unit == "\xE6m" || unit == "\xC2\xB5m" || unit == "\xCE\xBCm" ||
      unit == "um") {
    return 1e-6;
  }
  if (unit == "nm") return 1e-9;
  if (unit == "pm") return 1e-12;
  std::string shown(unit);
  std::replace_if(
      shown.begin(), shown.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  file.refuse(at,
              phrase("Stimuli",
                     "the unit is \"%1\"; m, mm, µm, nm and pm are possible. Export a surface of "
                     "heights")
                  .with(shown));
}

/// The bytes of the points: `expected` bytes from `at` on.
std::vector<std::byte> plain_points(const SurfaceBytes& file, std::size_t at,
                                    std::size_t expected) {
  const std::span<const std::byte> bytes = file.part(at, expected);
  return {bytes.begin(), bytes.end()};
}

/// The same from the streams of zlib that follow a table of their lengths.
std::vector<std::byte> expanded_points(const SurfaceBytes& file, std::size_t at,
                                       std::size_t expected) {
  const std::size_t streams = file.u32(at);
  const std::size_t table = at + 4;
  if (streams > file.size() / 8) {
    file.refuse(at, phrase("Stimuli",
                           "the table of compressed parts has %1 rows, more than the file can "
                           "contain; copy or export it again")
                        .with(std::to_string(streams)));
  }
  if (!can_expand_to(file.size(), expected)) {
    file.refuse(kColumns,
                phrase("Stimuli",
                       "the file is too short for its number of points; copy or export it again"));
  }
  std::vector<std::byte> points(expected);
  std::size_t done = 0;
  std::size_t from = table + 8 * streams;
  for (std::size_t i = 0; i < streams; ++i) {
    const std::size_t row = table + 8 * i;
    const std::size_t expanded = file.u32(row);
    const std::span<const std::byte> stream = file.part(from, file.u32(row + 4));
    if (expanded > expected - done) {
      file.refuse(
          row,
          phrase("Stimuli", "the compressed parts contain more than the points; export it again"));
    }
    uLongf written = expanded;
    const int status = uncompress(reinterpret_cast<Bytef*>(points.data() + done), &written,
                                  reinterpret_cast<const Bytef*>(stream.data()), stream.size());
    if (status == Z_MEM_ERROR) throw std::bad_alloc();
    if (status != Z_OK || written != expanded) {
      file.refuse(from, phrase("Stimuli",
                               "the compressed points are damaged; copy or export the file again"));
    }
    done += expanded;
    from += stream.size();
  }
  if (done != expected) {
    file.refuse(at, phrase("Stimuli",
                           "the compressed parts have %1 bytes, and the points take %2; export the "
                           "file again")
                        .with(std::to_string(done), std::to_string(expected)));
  }
  return points;
}

}  // namespace

MeasuredSurface decode_sur(std::span<const std::byte> bytes, const std::string& name) {
  const SurfaceBytes file(bytes, name);
  file.part(0, kHeaderBytes);
  if (file.u16(kByteOrder) != 0) {
    file.refuse(kByteOrder,
                phrase("Stimuli", "the byte order is not little-endian; export it for PCs"));
  }
  const int type = file.i16(kObjectType);
  if (type != kSurface && type != kProfile) {
    file.refuse(kObjectType, phrase("Stimuli",
                                    "the object has the type %1, and only type 2, a surface, is "
                                    "supported; export a surface")
                                 .with(std::to_string(type)));
  }
  const int bits = file.i16(kBitsPerPoint);
  if (bits != 16 && bits != 32) {
    file.refuse(kBitsPerPoint,
                phrase("Stimuli", "the points have %1 bits, not 16 or 32; export it again")
                    .with(std::to_string(bits)));
  }
  const Phrase problem = points_problem(file.u32(kColumns), file.u32(kRows));
  if (!problem.empty()) file.refuse(kColumns, problem);
  if (file.i16(kInversion) != 0) {
    file.refuse(
        kInversion,
        phrase("Stimuli",
               "the heights are marked as inverted, which programs interpret differently; save "
               "the surface without inversion"));
  }

  MeasuredSurface surface{.rows = file.u32(kRows), .columns = file.u32(kColumns)};
  surface.pitch_x_m = std::abs(file.f32(kSpacings)) * unit_in_m(file, kSpacingUnits);
  surface.pitch_y_m =
      std::abs(file.f32(kSpacings + 4)) * unit_in_m(file, kSpacingUnits + kUnitBytes);
  const double height_unit_m = unit_in_m(file, kSpacingUnits + 2 * kUnitBytes);
  const double step_m = file.f32(kSpacings + 8) * height_unit_m;
  const double offset_m = file.f32(kHeightOffset) * height_unit_m;
  if (!std::isfinite(step_m) || step_m == 0.0) {
    file.refuse(
        kSpacings + 8,
        phrase("Stimuli", "the height of a step is not a number other than 0; export it again"));
  }
  if (!std::isfinite(offset_m)) {
    file.refuse(kHeightOffset,
                phrase("Stimuli", "the offset of the heights is not a number; export it again"));
  }

  const std::size_t count = surface.rows * surface.columns;
  const std::size_t width = static_cast<std::size_t>(bits) / 8;
  const std::size_t data = kHeaderBytes + file.u16(kCommentBytes) + file.u16(kPrivateBytes);
  const bool is_compressed = file.begins_with("DSCOMPRESSED");
  const std::vector<std::byte> stored = is_compressed ? expanded_points(file, data, count * width)
                                                      : plain_points(file, data, count * width);
  const SurfaceBytes points(stored, name);
  const bool has_missing = file.i16(kSpecialPoints) == 1;
  const std::int64_t missing = std::int64_t{file.i32(kLeastHeight)} - 2;
  surface.heights_m.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::int64_t level = width == 2 ? points.i16(2 * i) : points.i32(4 * i);
    surface.heights_m[i] = has_missing && level == missing
                               ? std::numeric_limits<double>::quiet_NaN()
                               : static_cast<double>(level) * step_m + offset_m;
  }
  return surface;
}

}  // namespace asperity
