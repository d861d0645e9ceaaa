// Implements the decoding of a WAV file.

#include "renderers/recordings/wav_samples.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>

#include "analysis/numbers/number_text.h"

namespace asperity {
namespace {

constexpr std::uint32_t kPcm = 1;
constexpr std::uint32_t kFloat = 3;
constexpr std::uint32_t kExtensible = 0xFFFE;
constexpr std::size_t kChunkHeading_bytes = 8;

// A little-endian number of 1 to 4 bytes.
std::uint32_t unsigned_at(std::string_view bytes, std::size_t at, std::size_t count) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < count; ++i) {
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
  }
  return value;
}

struct Format {
  std::uint32_t code = 0;
  std::uint32_t channels = 0;
  std::uint32_t rate_Hz = 0;
  std::uint32_t bits = 0;
};

double sample_at(std::string_view data, std::size_t at, const Format& format) {
  const std::size_t bytes = format.bits / 8;
  const std::uint32_t raw = unsigned_at(data, at, bytes);
  if (format.code == kFloat) return std::bit_cast<float>(raw);
  // The sign bit to the top, as an integer of 32 bits.
  const auto value = static_cast<std::int32_t>(raw << (32 - format.bits));
  return static_cast<double>(value) / 2147483648.0;
}

}  // namespace

WavSamples wav_samples_in(std::string_view bytes, const std::string& name) {
  const auto refuse = [&name](const std::string& problem) {
    throw std::invalid_argument(name + ": " + problem);
  };
  if (bytes.size() < 12 || bytes.substr(0, 4) != "RIFF" || bytes.substr(8, 4) != "WAVE") {
    refuse("the file is not a WAV file; convert it to WAV with PCM of 16 or 24 bits");
  }
  Format format{};
  std::string_view data{};
  bool has_data = false;
  for (std::size_t at = 12; at + kChunkHeading_bytes <= bytes.size() && !has_data;) {
    const std::string_view id = bytes.substr(at, 4);
    const std::size_t size = unsigned_at(bytes, at + 4, 4);
    at += kChunkHeading_bytes;
    if (size > bytes.size() - at) {
      refuse("the file ends within a chunk of " + counted(size, "byte", "bytes") +
             "; copy or export the file again");
    }
    const std::string_view chunk = bytes.substr(at, size);
    if (id == "fmt " && size >= 16) {
      format = {.code = unsigned_at(chunk, 0, 2),
                .channels = unsigned_at(chunk, 2, 2),
                .rate_Hz = unsigned_at(chunk, 4, 4),
                .bits = unsigned_at(chunk, 14, 2)};
      // The first two bytes of the identifier of the format proper.
      if (format.code == kExtensible && size >= 26) format.code = unsigned_at(chunk, 24, 2);
    } else if (id == "data") {
      data = chunk;
      has_data = true;
    }
    at += size + size % 2;
  }
  if (format.rate_Hz == 0 || !has_data) {
    refuse(
        "the file has no samples or no format; export it again as WAV with PCM of 16 or 24 bits");
  }
  const bool is_pcm =
      format.code == kPcm && (format.bits == 16 || format.bits == 24 || format.bits == 32);
  if (!is_pcm && !(format.code == kFloat && format.bits == 32)) {
    refuse("the samples have the format " + std::to_string(format.code) + " with " +
           counted(format.bits, "bit", "bits") +
           ", which is not PCM of 16, 24 or 32 bits nor 32-bit floating point; convert the file "
           "to one of these");
  }
  if (format.channels != 1) {
    refuse("the file has " + std::to_string(format.channels) +
           " channels; export the channel of the texture as a file with one channel");
  }
  WavSamples wav{.rate_Hz = static_cast<double>(format.rate_Hz)};
  const std::size_t step = format.bits / 8;
  for (std::size_t at = 0; at + step <= data.size(); at += step) {
    wav.samples.push_back(sample_at(data, at, format));
    if (!std::isfinite(wav.samples.back())) {
      refuse("sample " + std::to_string(wav.samples.size()) +
             " is not a finite number; export the file again");
    }
  }
  return wav;
}

}  // namespace asperity
