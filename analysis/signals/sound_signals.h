// Declares signals for sounds: tones, pink noise, resampling, and peak limiting.

#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace asperity {

/// A tone that may glide, and the silence after it.
struct SoundTone {
  double from_Hz = 0.0;
  double to_Hz = 0.0;
  double duration_s = 0.0;
  double gap_s = 0.0;
  enum class Voice {
    sine,
    buzz,  ///< the odd harmonics of a square wave up to the ninth
  } voice = Voice::sine;
};

/// The nearest whole number of samples.
std::size_t samples_in(double duration_s, double rate_Hz);

/// Appends the samples of a tone at RMS 1 (without its edges), then its gap. The frequency glides exponentially; the tone
/// begins and ends with the square of a sine in 10 ms, to avoid clicks.
void append_tone(const SoundTone& tone, double rate_Hz, std::vector<float>& samples);

/// The samples at another rate, by cubic interpolation between them; beyond both ends there is silence. There is no
/// filter: content above half the lower rate is aliased.
std::vector<float> resampled(std::span<const float> samples, double from_rate_Hz,
                             double to_rate_Hz);

/// Pink noise from white noise of unit variance, at RMS 1: a sum of seven first-order filters [Kellett 2000], −3 dB per
/// octave within 0.5 dB from 50 Hz to 8 kHz at 44.1 or 48 kHz.
///
/// Real-time: `next` does not allocate, lock or throw; the constructor filters 20 000 samples.
///
/// [Kellett 2000] Kellett: Filter to make pink noise from white, musicdsp.org.
class PinkNoise final {
 public:
  PinkNoise() noexcept;

  double next(double white) noexcept;

 private:
  double filtered(double white) noexcept;

  std::array<double, 7> state_{};
  double scale_ = 1.0;
};

/// A sample whose size above 0.8 is compressed to 0.8 + 0.2·tanh((|x| − 0.8)/0.2), so that it stays within full scale.
///
/// Real-time: does not allocate, lock or throw.
double compressed_peak(double sample) noexcept;

}  // namespace asperity
