// Pictures as files: five formats, one brightness, and a refusal in words for everything else.

#include "stimuli/pictures/photograph.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include <gmock/gmock.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "analysis/words/phrased_error.h"
#include "tests/support/refusal.h"

namespace asperity {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;
using Bytes = std::vector<std::byte>;

Bytes encoded(const cv::Mat& pixels, const std::string& extension) {
  std::vector<unsigned char> file;
  cv::imencode(extension, pixels, file);
  const auto* first = reinterpret_cast<const std::byte*>(file.data());
  return {first, first + file.size()};
}

// 37 rows, 52 columns: brightness rises smoothly to the right and falls downwards.
cv::Mat ramp(int type) {
  const double white = CV_MAT_DEPTH(type) == CV_16U ? 65535.0 : 255.0;
  cv::Mat grey(37, 52, CV_64FC1);
  for (int i = 0; i < grey.rows; ++i) {
    for (int j = 0; j < grey.cols; ++j) {
      grey.at<double>(i, j) = white * (0.2 + 0.6 * j / 51.0 - 0.15 * i / 36.0);
    }
  }
  const std::vector<cv::Mat> channels(static_cast<std::size_t>(CV_MAT_CN(type)), grey);
  cv::Mat merged;
  cv::merge(channels, merged);
  merged.convertTo(merged, CV_MAT_DEPTH(type));
  return merged;
}

float expected_at(int i, int j) {
  return static_cast<float>(0.2 + 0.6 * j / 51.0 - 0.15 * i / 36.0);
}

std::string photograph_refusal(const Bytes& bytes) {
  return refusal_of<std::invalid_argument>([&] { decode_photograph(bytes, "wall.png"); });
}

void append_big_endian(Bytes& bytes, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) {
    bytes.push_back(static_cast<std::byte>(value >> static_cast<unsigned>(shift) & 0xFFU));
  }
}

Bytes bytes_of(std::string_view text) {
  const auto* first = reinterpret_cast<const std::byte*>(text.data());
  return {first, first + text.size()};
}

std::uint32_t crc_of(std::span<const std::byte> bytes) {  // of the PNG specification, bit by bit
  std::uint32_t crc = 0xFFFFFFFFU;
  for (const std::byte b : bytes) {
    crc ^= std::to_integer<std::uint32_t>(b);
    for (int k = 0; k < 8; ++k) crc = (crc & 1U) != 0 ? 0xEDB88320U ^ (crc >> 1U) : crc >> 1U;
  }
  return ~crc;
}

Bytes png_chunk(const Bytes& type_and_data) {
  Bytes chunk;
  append_big_endian(chunk, static_cast<std::uint32_t>(type_and_data.size() - 4));
  // One by one: gcc 12 sees an overread in a range insert here at -O3 that is none.
  for (const std::byte b : type_and_data) chunk.push_back(b);
  append_big_endian(chunk, crc_of(type_and_data));
  return chunk;
}

struct Case {
  std::string extension;
  int type;
  PictureFormat format;
  int bits;
  int channels;
  float tolerance;
};

const std::vector<Case> kCases{
    {".png", CV_8UC1, PictureFormat::png, 8, 1, 0.002F},
    {".png", CV_16UC1, PictureFormat::png, 16, 1, 1e-5F},
    {".png", CV_8UC3, PictureFormat::png, 8, 3, 0.002F},
    {".png", CV_16UC4, PictureFormat::png, 16, 4, 1e-5F},
    {".jpg", CV_8UC1, PictureFormat::jpeg, 8, 1, 0.02F},
    {".jpg", CV_8UC3, PictureFormat::jpeg, 8, 3, 0.02F},
    {".tif", CV_8UC1, PictureFormat::tiff, 8, 1, 0.002F},
    {".tif", CV_16UC1, PictureFormat::tiff, 16, 1, 1e-5F},
    {".tif", CV_16UC3, PictureFormat::tiff, 16, 3, 1e-5F},
    {".bmp", CV_8UC1, PictureFormat::bmp, 8, 3, 0.002F},
    {".bmp", CV_8UC3, PictureFormat::bmp, 8, 3, 0.002F},
    {".webp", CV_8UC3, PictureFormat::webp, 8, 3, 0.03F},
};

TEST(Photograph, IsTheSameBrightnessInEveryFormat) {
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.extension + " type " + std::to_string(c.type));
    const Photograph photograph = decode_photograph(encoded(ramp(c.type), c.extension), "ramp");
    EXPECT_EQ(photograph.facts.format, c.format);
    EXPECT_EQ(photograph.facts.bits_per_channel, c.bits);
    EXPECT_EQ(photograph.facts.channels, c.channels);
    ASSERT_EQ(photograph.grey.rows, 37u);
    ASSERT_EQ(photograph.grey.columns, 52u);
    float worst = 0.0F;
    for (int i = 0; i < 37; ++i) {
      for (int j = 0; j < 52; ++j) {
        const float value = photograph.grey.values[static_cast<std::size_t>(i * 52 + j)];
        worst = std::max(worst, std::abs(value - expected_at(i, j)));
      }
    }
    EXPECT_LT(worst, c.tolerance);
  }
}

TEST(Photograph, HeaderAloneTellsTheSameAsDecoding) {
  for (const Case& c : kCases) {
    const PictureFacts facts = inspect_picture(encoded(ramp(c.type), c.extension), "ramp");
    EXPECT_EQ(facts.format, c.format);
    EXPECT_EQ(facts.rows, 37u);
    EXPECT_EQ(facts.columns, 52u);
    EXPECT_EQ(facts.bits_per_channel, c.bits);
    EXPECT_EQ(facts.channels, c.channels);
  }
}

// Pure red, green and blue: 0.299, 0.587, 0.114 (Rec. 601). OpenCV stores blue first.
TEST(Photograph, WeighsColoursAsTheEyeDoes) {
  cv::Mat colours(1, 3, CV_8UC3);
  colours.at<cv::Vec3b>(0, 0) = {0, 0, 255};
  colours.at<cv::Vec3b>(0, 1) = {0, 255, 0};
  colours.at<cv::Vec3b>(0, 2) = {255, 0, 0};
  const GreyImage grey = decode_photograph(encoded(colours, ".png"), "colours").grey;
  EXPECT_NEAR(grey.values[0], 0.299, 1e-5);
  EXPECT_NEAR(grey.values[1], 0.587, 1e-5);
  EXPECT_NEAR(grey.values[2], 0.114, 1e-5);
}

// Red over green over blue, in areas that a JPEG keeps apart.
TEST(ColorPicture, KeepsItsColoursInEveryFormat) {
  cv::Mat colours(48, 32, CV_8UC3);
  for (int band = 0; band < 3; ++band) {
    cv::Vec3b color{51, 51, 51};
    color[2 - band] = 204;  // OpenCV: blue first
    colours.rowRange(16 * band, 16 * (band + 1)).setTo(color);
  }
  for (const char* extension : {".png", ".jpg", ".tif", ".bmp", ".webp"}) {
    SCOPED_TRACE(extension);
    const ColorPlanes planes = decode_color_picture(encoded(colours, extension), "bands");
    for (std::size_t plane = 0; plane < 3; ++plane) {
      ASSERT_EQ(planes[plane].rows, 48u);
      ASSERT_EQ(planes[plane].columns, 32u);
      for (std::size_t band = 0; band < 3; ++band) {
        EXPECT_NEAR(planes[plane].values[(16 * band + 8) * 32 + 16], plane == band ? 0.8 : 0.2, 0.1)
            << "plane " << plane << ", band " << band;
      }
    }
  }
  for (const Case& c : kCases) {
    if (c.channels >= 3) continue;
    const ColorPlanes grey = decode_color_picture(encoded(ramp(c.type), c.extension), "ramp");
    EXPECT_EQ(grey[0].values, grey[1].values);
    EXPECT_EQ(grey[1].values, grey[2].values);
  }
}

TEST(Photograph, IgnoresAlpha) {
  cv::Mat pixels(4, 4, CV_8UC4, cv::Scalar(51, 51, 51, 0));
  EXPECT_NEAR(decode_photograph(encoded(pixels, ".png"), "glass").grey.values[5], 0.2, 1e-5);
}

TEST(Photograph, IgnoresTheOrientationThatACameraNotes) {
  Bytes jpeg = encoded(ramp(CV_8UC1), ".jpg");
  // An EXIF segment whose only entry (0x0112) says: turn by 90 degrees (6).
  const Bytes exif = bytes_of(std::string_view(
      "\xFF\xE1\x00\x22"
      "Exif\0\0"
      "MM\x00\x2A\x00\x00\x00\x08\x00\x01\x01\x12\x00\x03\x00\x00\x00\x01\x00\x06\x00\x00"
      "\x00\x00\x00\x00",
      36));
  jpeg.insert(jpeg.begin() + 2, exif.begin(), exif.end());
  const Photograph photograph = decode_photograph(jpeg, "turned.jpg");
  EXPECT_EQ(photograph.grey.rows, 37u);
  EXPECT_EQ(photograph.grey.columns, 52u);
}

TEST(Photograph, IsKnownByItsContentAndNotByItsName) {
  EXPECT_EQ(inspect_picture(encoded(ramp(CV_8UC1), ".jpg"), "wall.png").format,
            PictureFormat::jpeg);
}

TEST(Photograph, RefusesInAnyLanguage) {
  try {
    inspect_picture({}, "wall.png");
    FAIL() << "an empty file is no picture";
  } catch (const PhrasedRefusal& refusal) {
    EXPECT_TRUE(refusal.said().can_be_translated());
    EXPECT_STREQ(refusal.what(), refusal.said().english().c_str());
  }
}

TEST(Photograph, RefusesWhatIsNoPictureWithTheNameAndWhatWouldBeRight) {
  EXPECT_EQ(photograph_refusal({}),
            "wall.png is empty; copy or export the picture (PNG, JPEG, TIFF, BMP or WebP) again.");
  EXPECT_EQ(
      photograph_refusal(bytes_of("{\"format\": 1}")),
      "wall.png is not a picture in a supported format; save it as PNG, JPEG, TIFF, BMP or WebP.");
  EXPECT_THAT(photograph_refusal(bytes_of("BM")), StartsWith("wall.png is truncated"));
}

// The header claims 20000 pixels and nothing follows: only the header can have been read.
TEST(Photograph, RefusesAGiganticPictureByItsHeaderAlone) {
  Bytes ihdr = bytes_of("IHDR");
  append_big_endian(ihdr, 20000);
  append_big_endian(ihdr, 100);
  for (const int b : {8, 0, 0, 0, 0}) ihdr.push_back(static_cast<std::byte>(b));
  Bytes png = bytes_of("\x89PNG\r\n\x1A\n");
  const Bytes chunk = png_chunk(ihdr);
  png.insert(png.end(), chunk.begin(), chunk.end());
  EXPECT_THAT(photograph_refusal(png), HasSubstr("wall.png is 20000 by 100 pixels; at most 16384"));

  Bytes jpeg = encoded(ramp(CV_8UC1), ".jpg");
  const Bytes mark = bytes_of("\xFF\xC0");
  const auto frame = std::search(jpeg.begin(), jpeg.end(), mark.begin(), mark.end());
  ASSERT_NE(frame, jpeg.end());
  *(frame + 5) = std::byte{0xFF};  // rows
  EXPECT_THAT(photograph_refusal(jpeg), HasSubstr("at most 16384"));
}

TEST(Photograph, RefusesNumbersThatAreNotWholeOrTooWide) {
  cv::Mat floats;
  ramp(CV_8UC1).convertTo(floats, CV_32F);
  EXPECT_THAT(photograph_refusal(encoded(floats, ".tif")), HasSubstr("32-bit floating-point"));
}

// OpenCV fills the rows that are missing in silence; a picture is read whole or not at all.
TEST(Photograph, RefusesEveryFileThatEndsEarly) {
  for (const Case& c : kCases) {
    const Bytes whole = encoded(ramp(c.type), c.extension);
    const std::size_t step = std::max<std::size_t>(1, whole.size() / 250);
    for (std::size_t length = 0; length + 1 < whole.size(); length += step) {
      const Bytes part(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length));
      EXPECT_NE(photograph_refusal(part), "") << c.extension << " cut to " << length;
      EXPECT_THROW(inspect_picture(part, "wall.png"), std::invalid_argument)
          << c.extension << " cut to " << length;
    }
  }
}

// Cut inside the scan and closed with an end mark, as some programs repair a file.
TEST(Photograph, RefusesAJpegWhoseEndWasGluedOn) {
  Bytes jpeg = encoded(ramp(CV_8UC3), ".jpg");
  jpeg.erase(jpeg.end() - static_cast<std::ptrdiff_t>(jpeg.size() / 8), jpeg.end());
  jpeg.push_back(std::byte{0xFF});
  jpeg.push_back(std::byte{0xD9});
  ::testing::internal::CaptureStderr();
  EXPECT_THAT(photograph_refusal(jpeg), HasSubstr("premature end of data"));
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

TEST(Photograph, LetsNoLibraryTalkToTheTerminal) {
  Bytes png = encoded(ramp(CV_8UC3), ".png");
  // A colour profile that libpng complains about.
  const Bytes profile = png_chunk(bytes_of(std::string_view("iCCPx\0\0junk", 11)));
  png.insert(png.begin() + 33, profile.begin(), profile.end());
  ::testing::internal::CaptureStderr();
  EXPECT_EQ(photograph_refusal(png), "");
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

TEST(Photograph, IsAnImageOrARefusalWhateverByteIsWrong) {
  ::testing::internal::CaptureStderr();
  for (const Case& c : kCases) {
    const Bytes whole = encoded(ramp(c.type), c.extension);
    const std::size_t step = std::max<std::size_t>(1, whole.size() / 120);
    for (std::size_t at = 0; at < whole.size(); at += step) {
      for (const int flip : {0x01, 0x80, 0xFF}) {
        Bytes damaged = whole;
        damaged[at] ^= static_cast<std::byte>(flip);
        try {
          const GreyImage grey = decode_photograph(damaged, "damaged").grey;
          EXPECT_EQ(grey.values.size(), grey.rows * grey.columns);
        } catch (const std::invalid_argument& error) {
          EXPECT_THAT(error.what(), StartsWith("damaged "));
        }
      }
    }
  }
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

TEST(GreyImage, BecomesAnEightBitPngThatRoundsAndClips) {
  const GreyImage image{2, 2, {-0.5F, 0.0F, 0.5F, 1.5F}};
  const Photograph back = decode_photograph(encode_png(image), "four");
  EXPECT_EQ(back.facts.bits_per_channel, 8);
  EXPECT_EQ(back.grey.values[0], 0.0F);
  EXPECT_NEAR(back.grey.values[2], 0.5, 0.51 / 255.0);
  EXPECT_EQ(back.grey.values[3], 1.0F);
  EXPECT_THROW(encode_png({2, 2, {0.0F}}), std::invalid_argument);
}

}  // namespace
}  // namespace asperity
