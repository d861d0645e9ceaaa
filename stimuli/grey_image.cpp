// Grey pictures to PNG.

#include "stimuli/grey_image.h"

#include <stdexcept>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>  // its constants only; the codecs are a module

#include "stimuli/picture_codecs.h"

namespace asperity {

std::vector<std::byte> encode_png(const GreyImage& image) {
  if (image.rows == 0 || image.columns == 0 || image.values.size() != image.rows * image.columns) {
    throw std::invalid_argument("A grey picture needs rows · columns values, and at least one.");
  }
  const cv::Mat brightness(static_cast<int>(image.rows), static_cast<int>(image.columns), CV_32FC1,
                           const_cast<float*>(image.values.data()));
  cv::Mat levels;
  brightness.convertTo(levels, CV_8U, 255.0);  // rounds and clips
  return picture_codecs().encode_png(levels, {cv::IMWRITE_PNG_COMPRESSION, 9});
}

}  // namespace asperity
