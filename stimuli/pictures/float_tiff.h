// Declares the decoding of TIFFs of floating-point numbers, which are not photographs.

#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "stimuli/pictures/grey_image.h"
#include "stimuli/pictures/photograph.h"

namespace asperity {

/// Whether a file is a TIFF of floating-point numbers.
///
/// Errors: std::invalid_argument that begins with `name`, for a TIFF whose header is damaged.
bool is_float_tiff(std::span<const std::byte> bytes, const std::string& name);

/// Reads the header of a greyscale TIFF of 32-bit floating-point numbers, as `inspect_picture` reads those of pictures.
///
/// Errors: those of `inspect_picture`, and for any other picture.
PictureFacts inspect_float_tiff(std::span<const std::byte> bytes, const std::string& name);

/// Decodes such a TIFF. The values are the stored numbers, which may be negative, infinite or NaN; NaN also where the file has its
/// stated value of missing points.
///
/// Errors: those of `inspect_float_tiff`, and for damaged data; about std::cerr as `decode_photograph`.
GreyImage decode_float_tiff(std::span<const std::byte> bytes, const std::string& name);

}  // namespace asperity
