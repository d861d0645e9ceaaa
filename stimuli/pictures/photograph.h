// From the bytes of a picture file to brightness.

#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "stimuli/pictures/grey_image.h"

namespace asperity {

enum class PictureFormat { png, jpeg, tiff, bmp, webp };

/// "PNG", "JPEG" and so on.
std::string_view name_of(PictureFormat format) noexcept;

/// The longest side that is accepted, in pixels.
inline constexpr std::size_t kLargestPictureSide = 16384;

/// What a picture's header says. `format` follows from the first bytes of the file, never from its
/// name.
struct PictureFacts {
  PictureFormat format = PictureFormat::png;
  std::size_t rows = 0;
  std::size_t columns = 0;
  int bits_per_channel = 0;
  int channels = 0;  ///< as decoded: a palette counts as 3; alpha counts
};

/// Reads the header, decodes nothing and holds nothing: a picture of any claimed size costs no
/// memory here.
///
/// Errors: std::invalid_argument, a sentence that begins with `name`, for a file that is empty, is
/// in none of the five formats, is cut off, is larger than kLargestPictureSide on a side, or stores
/// its pixels in a way that is not read here (numbers wider than 16 bits, CMYK, an animation).
PictureFacts inspect_picture(std::span<const std::byte> bytes, const std::string& name);

/// A decoded picture: brightness between 0 and 1.
struct Photograph {
  PictureFacts facts{};
  GreyImage grey{};
};

/// Decodes a picture to brightness: the stored numbers over the largest that fits, colour as
/// 0.299 R + 0.587 G + 0.114 B (Rec. 601). Brightness is as stored, not linear in light.
///
/// Alpha is ignored: a pixel counts with its colour, however transparent. The orientation that a
/// camera notes (EXIF) is ignored too: rows are the rows of the file. Of a file with several pages
/// the first is read.
///
/// Errors: as `inspect_picture`, and for a picture whose data are damaged or end early: a picture
/// is decoded whole or not at all. Nothing is written to the terminal; to that end std::cerr is
/// deaf while a TIFF, BMP or WebP is decoded, so do not write to it from another thread meanwhile.
Photograph decode_photograph(std::span<const std::byte> bytes, const std::string& name);

/// Decodes a picture with its colours, as stored; of a grey one the three planes are equal.
///
/// Alpha, orientation, pages and errors: as `decode_photograph`.
ColorPlanes decode_color_picture(std::span<const std::byte> bytes, const std::string& name);

}  // namespace asperity
