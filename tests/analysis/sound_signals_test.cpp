// Tones, pink noise and their samples.

#include "analysis/signals/sound_signals.h"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/numbers/random.h"

namespace asperity {
namespace {

double rms_of_samples(std::span<const float> samples) {
  double sum = 0.0;
  for (const float sample : samples) {
    sum += static_cast<double>(sample) * static_cast<double>(sample);
  }
  return std::sqrt(sum / static_cast<double>(samples.size()));
}

TEST(SoundTone, HasAnRmsOfOneBetweenItsEdgesAndSilenceAfterIt) {
  for (const auto voice : {SoundTone::Voice::sine, SoundTone::Voice::buzz}) {
    std::vector<float> samples{};
    append_tone({440.0, 440.0, 0.2, 0.1, voice}, 48000.0, samples);
    ASSERT_EQ(samples.size(), 14400U);
    EXPECT_EQ(samples.front(), 0.0F);
    const std::span<const float> whole(samples);
    EXPECT_NEAR(rms_of_samples(whole.subspan(960, 7680)), 1.0, 0.01);
    EXPECT_EQ(rms_of_samples(whole.subspan(9600)), 0.0);
  }
}

TEST(SoundTone, GlidesFromItsFirstFrequencyToItsLast) {
  std::vector<float> samples{};
  append_tone({200.0, 800.0, 1.0, 0.0}, 48000.0, samples);
  const auto crossings = [&samples](std::size_t from, std::size_t to) {
    int count = 0;
    for (std::size_t i = from + 1; i < to; ++i) {
      if (samples[i - 1] < 0.0F && samples[i] >= 0.0F) ++count;
    }
    return count;
  };
  // ∫ 200·4^t dt over a tenth of a second: 21.5 at the beginning, 74.6 at the end.
  EXPECT_NEAR(crossings(0, 4800), 21.5, 1.0);
  EXPECT_NEAR(crossings(43200, 48000), 74.6, 1.0);
}

TEST(Resampled, KeepsTheShapeAndTheDurationOfASlowSine) {
  std::vector<float> sine(1600);
  for (std::size_t i = 0; i < sine.size(); ++i) {
    sine[i] = static_cast<float>(std::sin(2.0 * std::numbers::pi * 0.02 * static_cast<double>(i)));
  }
  const std::vector<float> at_48_kHz = resampled(sine, 16000.0, 48000.0);
  ASSERT_EQ(at_48_kHz.size(), 4800U);
  for (std::size_t i = 30; i < 4700; ++i) {
    EXPECT_NEAR(static_cast<double>(at_48_kHz[i]),
                std::sin(2.0 * std::numbers::pi * 0.02 / 3.0 * static_cast<double>(i)), 2e-3);
  }
}

TEST(PinkNoise, HasTheRmsOfItsWhiteNoise) {
  PinkNoise pink;
  Random random(1);
  double sum = 0.0;
  constexpr int kSamples = 2'000'000;
  for (int i = 0; i < kSamples; ++i) {
    const double sample = pink.next(random.normal());
    sum += sample * sample;
  }
  EXPECT_NEAR(std::sqrt(sum / kSamples), 1.0, 0.02);
}

TEST(CompressedPeak, ChangesNothingBelowItsKneeAndStaysBelowFullScale) {
  EXPECT_EQ(compressed_peak(0.8), 0.8);
  EXPECT_EQ(compressed_peak(-0.3), -0.3);
  EXPECT_LT(compressed_peak(0.9), 0.9);
  EXPECT_EQ(compressed_peak(-0.9), -compressed_peak(0.9));
  EXPECT_LE(compressed_peak(100.0), 1.0);
}

}  // namespace
}  // namespace asperity
