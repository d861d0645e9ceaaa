// Declares OpenCV's picture codecs, which are loaded when the first picture is read or written.

#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <opencv2/core.hpp>

namespace asperity {

/// The functions of the module picture_codecs.so. OpenCV's codecs depend on GDAL and more than a hundred other
/// libraries, which take three times as long to load as the rest of the program; a command without pictures does not
/// load them.
struct PictureCodecs {
  /// Decodes a picture with its own channels and depth; empty if OpenCV cannot decode it.
  ///
  /// Errors: cv::Exception.
  cv::Mat (*decode)(std::span<const std::byte> file);

  /// Encodes a PNG; `parameters` are those of cv::imencode.
  ///
  /// Errors: cv::Exception.
  std::vector<std::byte> (*encode_png)(const cv::Mat& levels, const std::vector<int>& parameters);
};

/// Loads the module at the first call and keeps it until the process ends. May be called from any thread.
///
/// Errors: std::runtime_error if the module is missing or cannot be loaded; the next call tries again.
const PictureCodecs& picture_codecs();

}  // namespace asperity
