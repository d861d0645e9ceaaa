// Implements the module picture_codecs.so, the only code that is linked with OpenCV's codecs.

#include <opencv2/imgcodecs.hpp>

#include "stimuli/pictures/picture_codecs.h"

namespace {

cv::Mat decode(std::span<const std::byte> file) {
  // OpenCV requires a mutable pointer and does not change the bytes.
  const cv::Mat bytes(1, static_cast<int>(file.size()), CV_8UC1,
                      const_cast<std::byte*>(file.data()));
  return cv::imdecode(bytes, cv::IMREAD_UNCHANGED);
}

std::vector<std::byte> encode_png(const cv::Mat& levels, const std::vector<int>& parameters) {
  std::vector<unsigned char> png;
  cv::imencode(".png", levels, png, parameters);
  const auto* first = reinterpret_cast<const std::byte*>(png.data());
  return {first, first + png.size()};
}

}  // namespace

extern "C" const asperity::PictureCodecs asperity_picture_codecs{.decode = decode,
                                                                 .encode_png = encode_png};
