// Implements the decoding of pictures whose header has been checked.

#include "stimuli/pictures/photograph.h"

#include <algorithm>
#include <cstdint>
#include <iostream>
#include <limits>
#include <new>
#include <optional>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/core/utils/logger.hpp>

#include "analysis/words/phrased_error.h"
#include "stimuli/pictures/float_tiff.h"
#include "stimuli/pictures/jpeg_decoding.h"
#include "stimuli/pictures/picture_codecs.h"

namespace asperity {

namespace {

using Bytes = std::span<const std::byte>;

[[noreturn]] void refuse_damaged(const std::string& name, const Phrase& why) {
  throw PhrasedRefusal(
      phrase("Stimuli", "%1 is damaged: %2 Copy or export it again.").with(name, why));
}

std::uint32_t big_endian(Bytes bytes) {
  std::uint32_t value = 0;
  for (const std::byte b : bytes) value = value << 8U | std::to_integer<std::uint32_t>(b);
  return value;
}

/// Copies a PNG without the chunks that its pixels do not need: transparency, colour profiles, comments. libpng prints
/// warnings about those to the terminal. `inspect_picture` has checked the chunks.
std::vector<std::byte> without_ancillary_chunks(Bytes png) {
  constexpr std::size_t kSignature = 8;
  std::vector<std::byte> bare(png.begin(), png.begin() + kSignature);
  for (std::size_t at = kSignature; at + 12 <= png.size();) {
    const Bytes chunk = png.subspan(at, 12 + std::size_t{big_endian(png.subspan(at, 4))});
    // A lower-case first letter marks a chunk as ancillary.
    const bool critical = (chunk[4] & std::byte{0x20}) == std::byte{0};
    if (critical) bare.insert(bare.end(), chunk.begin(), chunk.end());
    const std::uint32_t type = big_endian(chunk.subspan(4, 4));
    if (type == 0x49454E44U) break;  // IEND; data after it are not part of the picture
    at += chunk.size();
  }
  return bare;
}

/// Silences OpenCV, which prints damage in files to std::cerr and its log before an error can be thrown.
class QuietOpenCV final {
 public:
  QuietOpenCV()
      : level_(cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT)),
        cerr_(std::cerr.rdbuf(nullptr)) {}
  ~QuietOpenCV() {
    std::cerr.rdbuf(cerr_);  // also clears the errors of writing to a null buffer
    cv::utils::logging::setLogLevel(level_);
  }
  QuietOpenCV(const QuietOpenCV&) = delete;
  QuietOpenCV& operator=(const QuietOpenCV&) = delete;

 private:
  cv::utils::logging::LogLevel level_;
  std::streambuf* cerr_;
};

cv::Mat decoded_by_opencv(Bytes bytes, const PictureFacts& facts, const std::string& name) {
  std::vector<std::byte> bare;
  if (facts.format == PictureFormat::png) {
    bare = without_ancillary_chunks(bytes);
    bytes = bare;
  }
  const PictureCodecs& codecs = picture_codecs();
  cv::Mat pixels;
  // A PNG has been checked to the last byte and causes no warnings.
  std::optional<QuietOpenCV> quiet;
  if (facts.format != PictureFormat::png) quiet.emplace();
  try {
    pixels = codecs.decode(bytes);
  } catch (const cv::Exception& error) {
    if (error.code == cv::Error::StsNoMem) throw std::bad_alloc();
    pixels.release();
  }
  quiet.reset();
  if (pixels.empty()) refuse_damaged(name, phrase("Stimuli", "its pixels cannot be decoded."));
  if (static_cast<std::size_t>(pixels.rows) != facts.rows ||
      static_cast<std::size_t>(pixels.cols) != facts.columns) {
    refuse_damaged(name,
                   phrase("Stimuli", "its number of pixels differs from that in its header."));
  }
  return pixels;
}

cv::Mat decoded_whole_numbers(Bytes bytes, const PictureFacts& facts, const std::string& name) {
  cv::Mat pixels = decoded_by_opencv(bytes, facts, name);
  if (pixels.depth() != CV_8U && pixels.depth() != CV_16U) {
    throw PhrasedRefusal(
        phrase("Stimuli",
               "%1 contains neither 8-bit nor 16-bit whole numbers. Save it with 8 or 16 bits per "
               "channel.")
            .with(name));
  }
  return pixels;
}

/// Errors: those of `decode_photograph`.
std::vector<std::uint8_t> decoded_jpeg(Bytes bytes, JpegPixels wanted, const PictureFacts& facts,
                                       const std::string& name) {
  std::vector<std::uint8_t> levels(facts.rows * facts.columns *
                                   (wanted == JpegPixels::colour ? 3 : 1));
  std::string complaint;
  if (!decode_jpeg(bytes, wanted, levels, facts.columns, complaint)) {
    refuse_damaged(name, "\"" + complaint + "\".");
  }
  return levels;
}

/// The brightness of one channel, from 0 to 1.
GreyImage plane_of(const cv::Mat& pixels, int channel) {
  cv::Mat levels;
  cv::extractChannel(pixels, levels, channel);
  GreyImage plane{static_cast<std::size_t>(pixels.rows), static_cast<std::size_t>(pixels.cols),
                  std::vector<float>(pixels.total())};
  cv::Mat brightness(pixels.rows, pixels.cols, CV_32FC1, plane.values.data());
  levels.convertTo(brightness, CV_32F, 1.0 / (pixels.depth() == CV_16U ? 65535.0 : 255.0));
  return plane;
}

template <class Number>
void to_brightness(const cv::Mat& pixels, float white, GreyImage& grey) {
  const int channels = pixels.channels();
  float* out = grey.values.data();
  for (int i = 0; i < pixels.rows; ++i) {
    const Number* in = pixels.ptr<Number>(i);
    for (int j = 0; j < pixels.cols; ++j, in += channels) {
      const float luma = channels < 3 ? static_cast<float>(in[0])
                                      : 0.114F * static_cast<float>(in[0]) +  // OpenCV: blue first
                                            0.587F * static_cast<float>(in[1]) +
                                            0.299F * static_cast<float>(in[2]);
      *out++ = luma / white;
    }
  }
}

}  // namespace

Photograph decode_photograph(Bytes bytes, const std::string& name) {
  Photograph photograph{.facts = inspect_picture(bytes, name), .grey = {}};
  PictureFacts& facts = photograph.facts;
  GreyImage& grey = photograph.grey;
  grey = {facts.rows, facts.columns, std::vector<float>(facts.rows * facts.columns)};

  if (facts.format == PictureFormat::jpeg) {
    const std::vector<std::uint8_t> luminance =
        decoded_jpeg(bytes, JpegPixels::luminance, facts, name);
    std::transform(luminance.begin(), luminance.end(), grey.values.begin(),
                   [](std::uint8_t level) { return static_cast<float>(level) / 255.0F; });
    return photograph;
  }
  const cv::Mat pixels = decoded_whole_numbers(bytes, facts, name);
  facts.bits_per_channel = pixels.depth() == CV_16U ? 16 : 8;
  if (pixels.depth() == CV_16U) {
    to_brightness<std::uint16_t>(pixels, 65535.0F, grey);
  } else {
    to_brightness<std::uint8_t>(pixels, 255.0F, grey);
  }
  return photograph;
}

ColorPlanes decode_color_picture(Bytes bytes, const std::string& name) {
  const PictureFacts facts = inspect_picture(bytes, name);
  if (facts.channels < 3) {
    const GreyImage grey = decode_photograph(bytes, name).grey;
    return {grey, grey, grey};
  }
  if (facts.format == PictureFormat::jpeg) {
    std::vector<std::uint8_t> levels = decoded_jpeg(bytes, JpegPixels::colour, facts, name);
    const cv::Mat pixels(static_cast<int>(facts.rows), static_cast<int>(facts.columns), CV_8UC3,
                         levels.data());
    return {plane_of(pixels, 0), plane_of(pixels, 1), plane_of(pixels, 2)};
  }
  const cv::Mat pixels = decoded_whole_numbers(bytes, facts, name);
  if (pixels.channels() < 3) {
    const GreyImage grey = plane_of(pixels, 0);
    return {grey, grey, grey};
  }
  return {plane_of(pixels, 2), plane_of(pixels, 1), plane_of(pixels, 0)};  // OpenCV: blue first
}

GreyImage decode_float_tiff(Bytes bytes, const std::string& name) {
  const PictureFacts facts = inspect_float_tiff(bytes, name);
  const cv::Mat pixels = decoded_by_opencv(bytes, facts, name);
  if (pixels.type() != CV_32FC1) {
    throw PhrasedRefusal(phrase("Stimuli",
                                "%1 does not contain one channel of 32-bit floating-point numbers. "
                                "Save the heights in this form.")
                             .with(name));
  }
  GreyImage image{facts.rows, facts.columns, std::vector<float>(facts.rows * facts.columns)};
  pixels.copyTo(cv::Mat(pixels.rows, pixels.cols, CV_32FC1, image.values.data()));
  if (facts.no_data) {
    std::replace(image.values.begin(), image.values.end(), *facts.no_data,
                 std::numeric_limits<float>::quiet_NaN());
  }
  return image;
}

}  // namespace asperity
