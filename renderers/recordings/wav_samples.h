// Declares the samples of a WAV file.

#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// One channel of a WAV file. ±1 is full scale.
struct WavSamples {
  double rate_Hz = 0.0;
  std::vector<double> samples{};
};

/// Decodes a WAV file with one channel of PCM of 16, 24 or 32 bits, or of 32-bit floating-point numbers; `name` names it in
/// messages. Chunks other than `fmt ` and `data` are skipped.
///
/// Errors: std::invalid_argument that begins with `name`, with the conversion that helps, for another format, several
/// channels, a file that ends early and samples that are not finite.
WavSamples wav_samples_in(std::string_view bytes, const std::string& name);

}  // namespace asperity
