// Implements tones, pink noise, another sampling rate, and a limit on peaks.

#include "analysis/signals/sound_signals.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>

namespace asperity {
namespace {

constexpr double kEdge_s = 0.010;
// The slowest pole of the pink filter has fallen to 10⁻¹⁰ after as many samples.
constexpr int kImpulseResponse = 20000;

}  // namespace

std::size_t samples_in(double duration_s, double rate_Hz) {
  return static_cast<std::size_t>(std::lround(duration_s * rate_Hz));
}

void append_tone(const SoundTone& tone, double rate_Hz, std::vector<float>& samples) {
  const std::size_t length = samples_in(tone.duration_s, rate_Hz);
  const double edge = kEdge_s * rate_Hz;
  constexpr double kTwoPi = 2.0 * std::numbers::pi;
  double phase = 0.0;
  for (std::size_t i = 0; i < length; ++i) {
    const double way = static_cast<double>(i) / static_cast<double>(length);
    phase += tone.from_Hz * std::pow(tone.to_Hz / tone.from_Hz, way) / rate_Hz;
    // The mean square of the odd harmonics up to the ninth is Σ 1/(2k²) = 0.592.
    double value = std::numbers::sqrt2 * std::sin(kTwoPi * phase);
    if (tone.voice == SoundTone::Voice::buzz) {
      value = 0.0;
      for (int k = 1; k <= 9; k += 2) value += std::sin(kTwoPi * k * phase) / k;
      value /= std::sqrt(0.592);
    }
    const double to_end = std::min(static_cast<double>(i), static_cast<double>(length - 1 - i));
    const double rise = std::sin(0.5 * std::numbers::pi * std::min(1.0, to_end / edge));
    samples.push_back(static_cast<float>(rise * rise * value));
  }
  samples.insert(samples.end(), samples_in(tone.gap_s, rate_Hz), 0.0F);
}

std::vector<float> resampled(std::span<const float> samples, double from_rate_Hz,
                             double to_rate_Hz) {
  const auto at = [samples](std::ptrdiff_t i) {
    return i < 0 || i >= std::ssize(samples)
               ? 0.0
               : static_cast<double>(samples[static_cast<std::size_t>(i)]);
  };
  std::vector<float> to(static_cast<std::size_t>(
      std::ceil(static_cast<double>(samples.size()) * to_rate_Hz / from_rate_Hz)));
  for (std::size_t i = 0; i < to.size(); ++i) {
    const double place = static_cast<double>(i) * from_rate_Hz / to_rate_Hz;
    const auto whole = static_cast<std::ptrdiff_t>(place);
    const double u = place - static_cast<double>(whole);
    const double a = at(whole - 1), b = at(whole), c = at(whole + 1), d = at(whole + 2);
    to[i] = static_cast<float>(
        b +
        0.5 * u * (c - a + u * (2.0 * a - 5.0 * b + 4.0 * c - d + u * (3.0 * (b - c) + d - a))));
  }
  return to;
}

PinkNoise::PinkNoise() noexcept {
  // The mean square of filtered white noise is the sum of the squares of the filter's impulse response.
  double mean_square = 0.0;
  for (int i = 0; i < kImpulseResponse; ++i) {
    const double response = filtered(i == 0 ? 1.0 : 0.0);
    mean_square += response * response;
  }
  scale_ = 1.0 / std::sqrt(mean_square);
  state_ = {};
}

double PinkNoise::filtered(double white) noexcept {
  state_[0] = 0.99886 * state_[0] + white * 0.0555179;
  state_[1] = 0.99332 * state_[1] + white * 0.0750759;
  state_[2] = 0.96900 * state_[2] + white * 0.1538520;
  state_[3] = 0.86650 * state_[3] + white * 0.3104856;
  state_[4] = 0.55000 * state_[4] + white * 0.5329522;
  state_[5] = -0.7616 * state_[5] - white * 0.0168980;
  const double pink = state_[0] + state_[1] + state_[2] + state_[3] + state_[4] + state_[5] +
                      state_[6] + white * 0.5362;
  state_[6] = white * 0.115926;
  return pink;
}

double PinkNoise::next(double white) noexcept { return scale_ * filtered(white); }

double compressed_peak(double sample) noexcept {
  constexpr double kKnee = 0.8;
  const double size = std::abs(sample);
  if (size <= kKnee) return sample;
  return std::copysign(kKnee + (1.0 - kKnee) * std::tanh((size - kKnee) / (1.0 - kKnee)), sample);
}

}  // namespace asperity
