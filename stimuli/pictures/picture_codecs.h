// OpenCV's picture codecs, loaded when the first picture is read or written.

#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <opencv2/core.hpp>

namespace asperity {

/// What the module picture_codecs.so offers. OpenCV's codecs bring GDAL and a hundred more libraries, which take three
/// times as long to load as the rest of the program; a command that touches no picture does without them.
struct PictureCodecs {
  /// The pixels of an encoded picture with their own channels and depth; empty where OpenCV cannot decode it.
  ///
  /// Errors: cv::Exception.
  cv::Mat (*decode)(std::span<const std::byte> file);

  /// The bytes of a PNG; `parameters` as cv::imencode takes them.
  ///
  /// Errors: cv::Exception.
  std::vector<std::byte> (*encode_png)(const cv::Mat& levels, const std::vector<int>& parameters);
};

/// Loads the module at the first call and keeps it until the process ends. Any thread may call.
///
/// Errors: std::runtime_error where the module is missing or cannot be loaded; the next call tries again.
const PictureCodecs& picture_codecs();

}  // namespace asperity
