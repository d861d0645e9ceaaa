// Implements the encoding of pictures as PNG.

#include "stimuli/pictures/grey_image.h"

#include <stdexcept>
#include <string>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>  // constants only; the codecs are a module

#include "stimuli/pictures/picture_codecs.h"

namespace asperity {

namespace {

cv::Mat brightness_of(const GreyImage& image) {
  if (image.rows == 0 || image.columns == 0 || image.values.size() != image.rows * image.columns) {
    throw std::invalid_argument(
        "the numbers of rows, columns and values of a greyscale picture are " +
        std::to_string(image.rows) + ", " + std::to_string(image.columns) + " and " +
        std::to_string(image.values.size()) +
        "; there must be rows · columns values, and at least one.");
  }
  return {static_cast<int>(image.rows), static_cast<int>(image.columns), CV_32FC1,
          const_cast<float*>(image.values.data())};
}

std::vector<std::byte> png_of(const cv::Mat& brightness) {
  cv::Mat levels;
  brightness.convertTo(levels, CV_8U, 255.0);  // rounds and clips
  return picture_codecs().encode_png(levels, {cv::IMWRITE_PNG_COMPRESSION, 9});
}

}  // namespace

std::vector<std::byte> encode_png(const GreyImage& image) { return png_of(brightness_of(image)); }

std::vector<std::byte> encode_color_png(const ColorPlanes& planes) {
  const auto& [red, green, blue] = planes;
  const std::array mats{brightness_of(blue), brightness_of(green), brightness_of(red)};
  if (mats[0].size() != mats[1].size() || mats[1].size() != mats[2].size()) {
    throw std::invalid_argument(
        "the red, green and blue channels of a picture differ in size; give all three the same "
        "size.");
  }
  cv::Mat colours;
  cv::merge(mats.data(), mats.size(), colours);
  return png_of(colours);
}

}  // namespace asperity
