// What the noise and the cues are, sample by sample.

#include "app/session/sound/masking_sound.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>

#include "analysis/signals/spectrum.h"
#include "tests/support/allocation_guard.h"

namespace asperity {
namespace {

constexpr double kRate_Hz = 48000.0;

MaskingSoundSettings settings_of(MaskingNoise::Kind kind, double gain = 0.1) {
  MaskingSoundSettings settings{};
  settings.noise.kind = kind;
  settings.noise.gain = gain;
  return settings;
}

struct Ears {
  std::vector<double> left{};
  std::vector<double> right{};
};

Ears listen(MaskingSound& sound, double duration_s) {
  std::vector<float> stereo(2 * 480);
  Ears ears{};
  for (int block = 0; block < static_cast<int>(std::lround(duration_s * 100.0)); ++block) {
    sound.fill(stereo);
    for (std::size_t i = 0; i < stereo.size(); i += 2) {
      ears.left.push_back(static_cast<double>(stereo[i]));
      ears.right.push_back(static_cast<double>(stereo[i + 1]));
    }
  }
  return ears;
}

double rms_of(std::span<const double> samples) {
  double sum = 0.0;
  for (const double sample : samples) sum += sample * sample;
  return std::sqrt(sum / static_cast<double>(samples.size()));
}

double peak_of(std::span<const double> samples) {
  double peak = 0.0;
  for (const double sample : samples) peak = std::max(peak, std::abs(sample));
  return peak;
}

/// The power of one frequency in 40 ms from `at_s`, relative to a sine of amplitude 1.
double tone_power(std::span<const double> samples, double at_s, double frequency_Hz) {
  const auto first = static_cast<std::size_t>(at_s * kRate_Hz);
  const auto length = static_cast<std::size_t>(0.04 * kRate_Hz);
  double c = 0.0, s = 0.0;
  for (std::size_t i = 0; i < length; ++i) {
    const double phase = 2.0 * std::numbers::pi * frequency_Hz * static_cast<double>(i) / kRate_Hz;
    c += samples[first + i] * std::cos(phase);
    s += samples[first + i] * std::sin(phase);
  }
  return 4.0 * (c * c + s * s) / static_cast<double>(length * length);
}

/// How often sound begins after at least 20 ms of silence.
int onsets(std::span<const double> samples) {
  int count = 0;
  int silence = 100000;
  for (const double sample : samples) {
    if (std::abs(sample) > 0.01) {
      if (silence > 960) ++count;
      silence = 0;
    } else {
      ++silence;
    }
  }
  return count;
}

Ears cue_alone(Cue cue, int number, double duration_s = 3.0) {
  MaskingSound sound(settings_of(MaskingNoise::Kind::none));
  sound.play(cue, number);
  return listen(sound, duration_s);
}

TEST(MaskingSound, NoiseHasTheRmsOfItsGainInBothEars) {
  const auto expect_rms = [](MaskingNoise::Kind kind, double gain, double duration_s) {
    MaskingSound sound(settings_of(kind, gain));
    sound.set_masking(true);
    listen(sound, 1.0);
    const Ears ears = listen(sound, duration_s);
    EXPECT_NEAR(rms_of(ears.left) / gain, 1.0, 0.01);
    EXPECT_NEAR(rms_of(ears.right) / gain, 1.0, 0.01);
  };
  // In 3 s the RMS of white noise has a standard error of 0.2 %, that of pink noise, of which the lowest octave has few
  // independent values, 1 %.
  for (const double gain : {0.02, 0.1, 0.25}) expect_rms(MaskingNoise::Kind::white, gain, 3.0);
  expect_rms(MaskingNoise::Kind::pink, 0.1, 30.0);
}

// In octaves from 50 Hz: white power doubles with every octave, pink power stays.
TEST(MaskingSound, PinkFallsByThreeDecibelsPerOctaveAndWhiteIsFlat) {
  for (const auto kind : {MaskingNoise::Kind::white, MaskingNoise::Kind::pink}) {
    MaskingSound sound(settings_of(kind));
    sound.set_masking(true);
    listen(sound, 1.0);
    const Ears ears = listen(sound, 60.0);
    const PowerSpectrum spectrum =
        welch_spectrum(ears.left, {.rate_Hz = kRate_Hz, .length = 16384});
    const auto density_dB = [&spectrum](double low_Hz, double high_Hz) {
      return 10.0 * std::log10(band_power(spectrum, {.low_Hz = low_Hz, .high_Hz = high_Hz}) /
                               (high_Hz - low_Hz));
    };
    const double slope_dB = kind == MaskingNoise::Kind::pink ? -10.0 * std::log10(2.0) : 0.0;
    const double first_dB = density_dB(400.0, 800.0);
    for (int octave = -3; octave <= 3; ++octave) {  // 50–100 Hz … 3.2–6.4 kHz
      const double low_Hz = 400.0 * std::pow(2.0, octave);
      EXPECT_NEAR(density_dB(low_Hz, 2.0 * low_Hz) - first_dB, slope_dB * octave, 0.5)
          << "octave from " << low_Hz << " Hz";
    }
    EXPECT_NEAR(density_dB(4000.0, 8000.0) - density_dB(2000.0, 4000.0), slope_dB, 0.5);
  }
}

constexpr double kLow_Hz = 220.0;
constexpr double kHigh_Hz = 1760.0;

TEST(MaskingSound, GuidesByALowToneBelowAndAHighOneAboveAndBySilenceInside) {
  MaskingSound sound(settings_of(MaskingNoise::Kind::none));
  EXPECT_EQ(peak_of(listen(sound, 0.5).left), 0.0);
  struct {
    GuideTone tone;
    double frequency_Hz;
    int onsets_in_1200_ms;
  } const kCases[] = {{GuideTone::press_more, kLow_Hz, 4},
                      {GuideTone::press_less, kHigh_Hz, 4},
                      {GuideTone::faster, kLow_Hz, 6},
                      {GuideTone::slower, kHigh_Hz, 6}};
  for (const auto& [tone, frequency_Hz, onsets_in_1200_ms] : kCases) {
    sound.set_guide(tone);
    const Ears ears = listen(sound, 1.2);
    EXPECT_EQ(onsets(ears.left), onsets_in_1200_ms);
    EXPECT_EQ(ears.left, ears.right);
    const double other_Hz = frequency_Hz == kLow_Hz ? kHigh_Hz : kLow_Hz;
    EXPECT_GT(tone_power(ears.left, 0.005, frequency_Hz), 1e-3);
    EXPECT_LT(tone_power(ears.left, 0.005, other_Hz), 1e-4);
    sound.set_guide(GuideTone::none);
    listen(sound, 0.02);  // fades out
    EXPECT_EQ(peak_of(listen(sound, 0.5).left), 0.0);
  }
}

TEST(MaskingSound, LetsACueBeHeardAloneWhileItGuides) {
  MaskingSound sound(settings_of(MaskingNoise::Kind::none));
  sound.set_guide(GuideTone::press_more);
  listen(sound, 0.3);
  sound.play(Cue::accepted, 0);  // 1318.5 Hz for 0.25 s
  const Ears ears = listen(sound, 1.0);
  EXPECT_GT(tone_power(ears.left, 0.1, 1318.51), 1e-3);
  EXPECT_LT(tone_power(ears.left, 0.1, kLow_Hz), 1e-4);
  EXPECT_LT(tone_power(ears.left, 0.3, kLow_Hz), 1e-4);  // what two cues are told apart by
  EXPECT_GT(tone_power(ears.left, 0.42, kLow_Hz), 1e-3);
}

// A window of 40 ms hears a band of 25 Hz; the ear's around 220 and 1760 Hz are 48 and 215 Hz wide.
TEST(MaskingSound, GuidesEighteenDecibelsAboveTheNoiseInTheEarsBand) {
  for (const auto kind : {MaskingNoise::Kind::white, MaskingNoise::Kind::pink}) {
    MaskingSound sound(settings_of(kind));
    sound.set_masking(true);
    listen(sound, 1.0);
    const Ears noise = listen(sound, 8.0);
    const auto in_noise = [&](double frequency_Hz) {
      double sum = 0.0;
      for (int i = 0; i < 190; ++i) sum += tone_power(noise.left, 0.04 * i, frequency_Hz);
      return sum / 190.0;
    };
    MaskingSound silent(settings_of(MaskingNoise::Kind::none));
    silent.set_guide(GuideTone::press_more);
    const double low = tone_power(listen(silent, 1.0).left, 0.05, kLow_Hz);
    silent.set_guide(GuideTone::none);
    listen(silent, 0.1);
    silent.set_guide(GuideTone::press_less);
    const double high = tone_power(listen(silent, 1.0).left, 0.05, kHigh_Hz);
    EXPECT_GT(10.0 * std::log10(low / (in_noise(kLow_Hz) * 48.0 / 25.0)), 18.0);
    EXPECT_GT(10.0 * std::log10(high / (in_noise(kHigh_Hz) * 215.0 / 25.0)), 18.0);
  }
}

TEST(MaskingSound, NoiseIsIndependentInBothEars) {
  MaskingSound sound(settings_of(MaskingNoise::Kind::white));
  sound.set_masking(true);
  const Ears ears = listen(sound, 10.0);
  double product = 0.0;
  for (std::size_t i = 0; i < ears.left.size(); ++i) product += ears.left[i] * ears.right[i];
  const double correlation =
      product / static_cast<double>(ears.left.size()) / (rms_of(ears.left) * rms_of(ears.right));
  EXPECT_NEAR(correlation, 0.0, 0.01);  // ±1/√480000 is one standard error
}

TEST(MaskingSound, NoiseFadesInAndOutInAFifthOfASecond) {
  MaskingSound sound(settings_of(MaskingNoise::Kind::white));
  const auto loudness = [&sound](double duration_s) {
    return rms_of(listen(sound, duration_s).left);
  };
  EXPECT_EQ(loudness(0.1), 0.0);
  sound.set_masking(true);
  const double beginning = loudness(0.02);
  EXPECT_GT(beginning, 0.0);
  EXPECT_LT(beginning, 0.01);
  loudness(0.18);
  EXPECT_NEAR(loudness(0.1), 0.1, 0.01);
  sound.set_masking(false);
  EXPECT_NEAR(loudness(0.02), 0.1, 0.01);
  loudness(0.19);
  EXPECT_EQ(loudness(0.1), 0.0);
}

TEST(MaskingSound, TheSameSeedGivesTheSameSamples) {
  auto settings = settings_of(MaskingNoise::Kind::pink);
  const auto hear = [&settings] {
    MaskingSound sound(settings);
    sound.set_masking(true);
    sound.play(Cue::question, 0);
    return listen(sound, 0.5).left;
  };
  const auto first = hear();
  EXPECT_EQ(hear(), first);
  settings.seed = 2;
  EXPECT_NE(hear(), first);
}

TEST(MaskingSound, ASurfaceHasAsManyTonesAsItsNumber) {
  for (const int number : {1, 3, 6}) {
    EXPECT_EQ(onsets(cue_alone(Cue::surface, number).left), number);
    EXPECT_EQ(onsets(cue_alone(Cue::option, number).left), number);
  }
  const auto surface = cue_alone(Cue::surface, 1).left;
  const auto option = cue_alone(Cue::option, 1).left;
  EXPECT_GT(tone_power(surface, 0.03, 440.0), 100.0 * tone_power(surface, 0.03, 1046.5));
  EXPECT_GT(tone_power(option, 0.03, 1046.5), 100.0 * tone_power(option, 0.03, 440.0));
}

TEST(MaskingSound, MovementTellsAQuestionFromAnErrorAndTheMasksApart) {
  const auto question = cue_alone(Cue::question, 0).left;
  EXPECT_GT(tone_power(question, 0.05, 523.25), 10.0 * tone_power(question, 0.05, 698.46));
  EXPECT_GT(tone_power(question, 0.25, 698.46), 10.0 * tone_power(question, 0.25, 523.25));
  const auto wrong = cue_alone(Cue::wrong, 0).left;
  EXPECT_GT(tone_power(wrong, 0.05, 392.0), 10.0 * tone_power(wrong, 0.05, 277.18));
  EXPECT_GT(tone_power(wrong, 0.25, 277.18), 10.0 * tone_power(wrong, 0.25, 392.0));
  const auto on = cue_alone(Cue::mask_on, 0).left;
  const auto off = cue_alone(Cue::mask_off, 0).left;
  EXPECT_GT(tone_power(on, 0.02, 850.0), 10.0 * tone_power(on, 0.74, 850.0));
  EXPECT_GT(tone_power(off, 0.74, 850.0), 10.0 * tone_power(off, 0.02, 850.0));
}

TEST(MaskingSound, NoTwoCuesSoundAlike) {
  std::vector<std::vector<double>> heard{};
  for (const Cue cue : {Cue::surface, Cue::next, Cue::question, Cue::option, Cue::accepted,
                        Cue::refused, Cue::right, Cue::wrong, Cue::rest, Cue::paused, Cue::mask_on,
                        Cue::mask_off, Cue::finished}) {
    heard.push_back(cue_alone(cue, 1, 1.5).left);
    EXPECT_GT(peak_of(heard.back()), 0.1) << cue_name(cue, 1);
  }
  for (std::size_t i = 0; i < heard.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      double product = 0.0;
      for (std::size_t k = 0; k < heard[i].size(); ++k) product += heard[i][k] * heard[j][k];
      const double likeness =
          product / static_cast<double>(heard[i].size()) / (rms_of(heard[i]) * rms_of(heard[j]));
      EXPECT_LT(std::abs(likeness), 0.7) << i << " and " << j;
    }
  }
}

TEST(MaskingSound, ACueIsLouderThanTheNoise) {
  const auto tone = cue_alone(Cue::accepted, 0).left;
  const auto begin = tone.begin() + 2400;  // its middle, without the edges
  EXPECT_NEAR(rms_of(std::span(begin, begin + 4800)), 1.5 * 0.1, 0.003);
}

TEST(MaskingSound, NothingClipsAtTheHighestGain) {
  MaskingSound sound(settings_of(MaskingNoise::Kind::white, MaskingSound::kHighestGain));
  sound.set_masking(true);
  double peak = 0.0;
  for (int i = 0; i < 40; ++i) {
    sound.play(Cue::finished, 0);
    peak = std::max(peak, peak_of(listen(sound, 1.0).left));
  }
  EXPECT_GT(peak, 0.9);  // the bend was needed
  EXPECT_LT(peak, 1.0);
}

TEST(MaskingSound, CuesWaitForEachOther) {
  MaskingSound sound(settings_of(MaskingNoise::Kind::none));
  sound.play(Cue::accepted, 0);
  sound.play(Cue::surface, 2);
  EXPECT_EQ(onsets(listen(sound, 2.0).left), 3);
}

TEST(MaskingSound, AnOptionCutsAnEarlierOneOff) {
  MaskingSound sound(settings_of(MaskingNoise::Kind::none));
  sound.play(Cue::option, 20);
  EXPECT_EQ(onsets(listen(sound, 0.3).left), 2);
  sound.play(Cue::option, 5);
  sound.play(Cue::option, 1);
  EXPECT_LE(onsets(listen(sound, 1.0).left), 2);  // what was left of the tone, and the new one
  EXPECT_EQ(rms_of(listen(sound, 1.0).left), 0.0);
}

TEST(MaskingSound, ACueThatFindsNoPlaceIsCounted) {
  MaskingSound sound(settings_of(MaskingNoise::Kind::none));
  for (int i = 0; i < 16; ++i) sound.play(Cue::refused, 0);
  EXPECT_EQ(sound.cues_lost(), 0U);
  sound.play(Cue::refused, 0);
  EXPECT_EQ(sound.cues_lost(), 1U);
}

TEST(MaskingSound, ARecordedWordTakesThePlaceOfATone) {
  auto settings = settings_of(MaskingNoise::Kind::none);
  CueRecording word{.rate_Hz = 16000.0, .samples = std::vector<float>(8000)};
  for (std::size_t i = 0; i < word.samples.size(); ++i) {
    word.samples[i] = 0.01F * static_cast<float>(std::sin(2.0 * std::numbers::pi * 300.0 *
                                                          static_cast<double>(i) / 16000.0));
  }
  settings.speech["surface_2"] = word;
  MaskingSound sound(settings);
  sound.play(Cue::surface, 2);
  const auto heard = listen(sound, 1.0).left;
  EXPECT_EQ(onsets(heard), 1);
  // Brought to the level of a cue, at its own pitch and for as long as it was spoken.
  EXPECT_NEAR(rms_of(std::span(heard).first(24000)), 0.15, 0.001);
  EXPECT_GT(tone_power(heard, 0.2, 300.0), 100.0 * tone_power(heard, 0.2, 440.0));
  sound.play(Cue::surface, 1);
  EXPECT_GT(tone_power(listen(sound, 1.0).left, 0.03, 440.0), 0.01);
}

TEST(MaskingSound, TheGainCanBeTurnedWhileItSounds) {
  MaskingSound sound(settings_of(MaskingNoise::Kind::white));
  sound.set_masking(true);
  listen(sound, 1.0);
  sound.set_gain(0.05);
  listen(sound, 0.2);
  EXPECT_NEAR(rms_of(listen(sound, 5.0).left), 0.05, 0.0005);
}

TEST(MaskingSound, RefusesWhatItCannotPlay) {
  EXPECT_THROW(MaskingSound(settings_of(MaskingNoise::Kind::white, 0.0)), std::invalid_argument);
  EXPECT_THROW(MaskingSound(settings_of(MaskingNoise::Kind::white, 0.3)), std::invalid_argument);
  auto slow = settings_of(MaskingNoise::Kind::white);
  slow.rate_Hz = 4000.0;
  EXPECT_THROW(MaskingSound{slow}, std::invalid_argument);
  auto silent = settings_of(MaskingNoise::Kind::white);
  silent.speech["question"] = {.rate_Hz = 16000.0, .samples = std::vector<float>(100)};
  EXPECT_THROW(MaskingSound{silent}, std::invalid_argument);
  auto unknown = settings_of(MaskingNoise::Kind::white);
  unknown.speech["surfaces"] = {.rate_Hz = 16000.0, .samples = {0.1F, -0.1F}};
  EXPECT_THROW(MaskingSound{unknown}, std::invalid_argument);
}

TEST(MaskingSound, FillingDoesNotTouchTheHeap) {
  MaskingSound sound(settings_of(MaskingNoise::Kind::pink));
  std::vector<float> stereo(960);
  sound.set_masking(true);
  for (int i = 0; i < 6; ++i) sound.play(Cue::option, i + 1);
  sound.play(Cue::refused, 0);
  AllocationGuard guard;
  for (int i = 0; i < 300; ++i) sound.fill(stereo);
  EXPECT_EQ(guard.count(), 0);
}

TEST(MaskingSound, CuesMayComeFromManyThreads) {
  MaskingSound sound(settings_of(MaskingNoise::Kind::white));
  std::atomic<int> asked{0};
  {
    const auto ask = [&] {
      for (int i = 0; i < 200; ++i) {
        sound.play(Cue::accepted, 0);
        sound.set_masking(i % 2 == 0);
        asked.fetch_add(1);
      }
    };
    std::jthread one(ask);
    std::jthread two(ask);
    std::vector<float> stereo(64);
    while (asked.load() < 400) sound.fill(stereo);
  }
  EXPECT_LE(sound.cues_lost(), 400U);
}

}  // namespace
}  // namespace asperity
