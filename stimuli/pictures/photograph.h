// Declares the decoding of picture files to brightness.

#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "stimuli/pictures/grey_image.h"

namespace asperity {

enum class PictureFormat { png, jpeg, tiff, bmp, webp };

/// The format's name: "PNG", "JPEG" and so on.
std::string_view name_of(PictureFormat format) noexcept;

/// The greatest accepted side length, in pixels.
inline constexpr std::size_t kLargestPictureSide = 16384;

/// The facts in a picture's header. `format` is determined from the first bytes of the file, never from its name.
struct PictureFacts {
  PictureFormat format = PictureFormat::png;
  std::size_t rows = 0;
  std::size_t columns = 0;
  int bits_per_channel = 0;
  int channels = 0;                ///< as decoded: a palette counts as 3; alpha counts
  bool has_further_pages = false;  ///< of a TIFF; the first is read
  /// The stored number of a missing point, of a TIFF with GDAL's entry 42113.
  std::optional<float> no_data{};
};

/// Reads the header without decoding or allocating pixels: memory use does not depend on the claimed size.
///
/// Errors: std::invalid_argument with a sentence that begins with `name`, for a file that is empty, has none of the
/// five formats, is truncated, is larger than kLargestPictureSide on a side, or uses an unsupported pixel format
/// (numbers wider than 16 bits, CMYK, an animation).
PictureFacts inspect_picture(std::span<const std::byte> bytes, const std::string& name);

/// A decoded picture with brightness from 0 to 1.
struct Photograph {
  PictureFacts facts{};
  GreyImage grey{};
};

/// Decodes a picture to brightness: the stored numbers divided by their greatest possible value, colour as 0.299 R +
/// 0.587 G + 0.114 B (Rec. 601). Brightness is as stored, not linear in light.
///
/// Alpha is ignored: a pixel has its stored colour regardless of transparency. The camera's orientation tag (EXIF) is
/// ignored: rows are the rows of the file; a TIFF with another orientation than 1 is refused. Of a file with several pages the first is read.
///
/// Errors: those of `inspect_picture`, and for a picture whose data are damaged or end early: a picture is decoded
/// completely or not at all. Nothing is printed to the terminal: output to std::cerr is discarded while a TIFF, BMP or
/// WebP is decoded, so other threads must not write to it during that time.
Photograph decode_photograph(std::span<const std::byte> bytes, const std::string& name);

/// Decodes a picture with its colours, as stored; the three planes of a grey picture are equal.
///
/// Alpha, orientation, pages and errors: those of `decode_photograph`.
ColorPlanes decode_color_picture(std::span<const std::byte> bytes, const std::string& name);

}  // namespace asperity
