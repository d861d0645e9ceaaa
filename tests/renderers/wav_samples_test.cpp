// The samples of WAV files of each accepted format, and the refusals of others.

#include "renderers/recordings/wav_samples.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/refusal.h"

namespace asperity {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string little_endian(std::uint32_t value, std::size_t bytes) {
  std::string text{};
  for (std::size_t i = 0; i < bytes; ++i) text += static_cast<char>(value >> (8 * i) & 0xFF);
  return text;
}

std::string wav_chunk(const std::string& id, const std::string& content) {
  return id + little_endian(static_cast<std::uint32_t>(content.size()), 4) + content +
         (content.size() % 2 == 1 ? std::string(1, '\0') : "");
}

struct WavFormat {
  std::uint32_t code = 1;
  std::uint32_t channels = 1;
  std::uint32_t bits = 16;
};

std::string format_chunk(const WavFormat& format) {
  const std::uint32_t frame = format.channels * format.bits / 8;
  return wav_chunk("fmt ", little_endian(format.code, 2) + little_endian(format.channels, 2) +
                               little_endian(8000, 4) + little_endian(8000 * frame, 4) +
                               little_endian(frame, 2) + little_endian(format.bits, 2));
}

std::string wav_file(const std::string& format, const std::string& data) {
  const std::string chunks = format + wav_chunk("LIST", "odd") + wav_chunk("data", data);
  return "RIFF" + little_endian(static_cast<std::uint32_t>(chunks.size() + 4), 4) + "WAVE" + chunks;
}

std::string refusal_of_wav(const std::string& bytes) {
  return refusal_of<std::invalid_argument>([&] { wav_samples_in(bytes, "felt.wav"); });
}

TEST(WavSamples, AreThoseOfEachFormat) {
  const auto of_16 = wav_samples_in(
      wav_file(format_chunk({}), little_endian(0x4000, 2) + little_endian(0x8000, 2)), "felt.wav");
  EXPECT_EQ(of_16.rate_Hz, 8000.0);
  EXPECT_THAT(of_16.samples, ElementsAre(0.5, -1.0));
  EXPECT_THAT(wav_samples_in(wav_file(format_chunk({.bits = 24}),
                                      little_endian(0x400000, 3) + little_endian(0xC00000, 3)),
                             "felt.wav")
                  .samples,
              ElementsAre(0.5, -0.5));
  EXPECT_THAT(wav_samples_in(wav_file(format_chunk({.bits = 32}), little_endian(0xE0000000U, 4)),
                             "felt.wav")
                  .samples,
              ElementsAre(-0.25));
  EXPECT_THAT(wav_samples_in(wav_file(format_chunk({.code = 3, .bits = 32}),
                                      little_endian(std::bit_cast<std::uint32_t>(1.5F), 4)),
                             "felt.wav")
                  .samples,
              ElementsAre(1.5));
}

// As recorders write more than two channels or 16 bits: the format proper is in an identifier.
TEST(WavSamples, AreReadFromTheExtensibleFormat) {
  const std::string format =
      wav_chunk("fmt ", little_endian(0xFFFE, 2) + little_endian(1, 2) + little_endian(8000, 4) +
                            little_endian(24000, 4) + little_endian(3, 2) + little_endian(24, 2) +
                            little_endian(22, 2) + little_endian(24, 2) + little_endian(4, 4) +
                            little_endian(1, 2) + std::string(14, 'x'));
  EXPECT_THAT(wav_samples_in(wav_file(format, little_endian(0x200000, 3)), "felt.wav").samples,
              ElementsAre(0.25));
}

TEST(WavSamples, RefuseOtherFilesWithTheirNameAndTheCorrection) {
  EXPECT_THAT(refusal_of_wav("ID3 of a song"),
              testing::AllOf(testing::StartsWith("felt.wav: "), HasSubstr("is not a WAV file"),
                             HasSubstr("convert it")));
  EXPECT_THAT(refusal_of_wav(wav_file(format_chunk({.code = 85, .bits = 0}), "xx")),
              testing::AllOf(testing::StartsWith("felt.wav: "), HasSubstr("format 85"),
                             HasSubstr("not PCM"), HasSubstr("convert")));
  EXPECT_THAT(refusal_of_wav(wav_file(format_chunk({.bits = 8}), "xx")), HasSubstr("8 bits"));
  EXPECT_THAT(refusal_of_wav(wav_file(format_chunk({.channels = 2}), "xxxx")),
              HasSubstr("has 2 channels"));
  const std::string whole = wav_file(format_chunk({}), "abcdefgh");
  EXPECT_THAT(refusal_of_wav(whole.substr(0, whole.size() - 3)), HasSubstr("ends within a chunk"));
  EXPECT_THAT(refusal_of_wav(whole.substr(0, 12)), HasSubstr("no samples or no format"));
  EXPECT_THAT(
      refusal_of_wav(wav_file(
          format_chunk({.code = 3, .bits = 32}),
          little_endian(std::bit_cast<std::uint32_t>(std::numeric_limits<float>::infinity()), 4))),
      HasSubstr("sample 1 is not a finite number"));
}

// Whatever a file claims, nothing outside of it is read.
TEST(WavSamples, OfFilesCutAnywhereAreReadOrRefused) {
  const std::string whole = wav_file(format_chunk({}), "abcdefgh");
  for (std::size_t length = 0; length < whole.size(); ++length) {
    try {
      wav_samples_in(whole.substr(0, length), "felt.wav");
    } catch (const std::invalid_argument&) {
    }
  }
}

}  // namespace
}  // namespace asperity
