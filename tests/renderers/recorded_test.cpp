// The vibration of a recorded texture: its spectra at and between the recorded speeds, the hand at rest, and refusals.

#include "renderers/models/recorded.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/numbers/random.h"
#include "analysis/signals/spectrum.h"
#include "renderers/offline/along_path.h"
#include "renderers/recordings/recorded_spectra.h"
#include "tests/renderers/surfaces.h"
#include "tests/support/refusal.h"

namespace asperity {
namespace {

constexpr double kRecordedRate_Hz = 2000.0;

/// A stroke of 0.2 m whose force is a function of the path.
template <class Force>
RecordedStroke recorded_stroke(double speed_m_per_s, double normal_N, const Force& force_N) {
  RecordedStroke stroke{};
  const auto samples = static_cast<int>(std::lround(0.2 / speed_m_per_s * kRecordedRate_Hz));
  for (int i = 0; i < samples; ++i) {
    const double time_s = i / kRecordedRate_Hz;
    stroke.time_s.push_back(time_s);
    stroke.path_m.push_back(time_s * speed_m_per_s);
    stroke.normal_N.push_back(normal_N);
    stroke.force_N.push_back(force_N(time_s * speed_m_per_s));
  }
  return stroke;
}

/// Coloured noise in time, between 5 and 400 Hz for the most part.
RecordedStroke noisy_stroke(double speed_m_per_s, double sd_N, std::uint64_t seed) {
  Random random(seed);
  double low_N = 0.0;
  RecordedStroke stroke = recorded_stroke(speed_m_per_s, 1.0, [](double) { return 0.0; });
  for (double& force_N : stroke.force_N) {
    low_N += 0.4 * (sd_N * random.normal() - low_N);
    force_N = 0.3 + low_N;  // on the drag of the plate
  }
  return stroke;
}

std::shared_ptr<const std::string> table_of_recording(const TextureRecording& recording) {
  return std::make_shared<const std::string>(tsv_of(recording));
}

RendererInputs of_recording(const TextureRecording& recording, ParameterValues parameters = {}) {
  RendererInputs inputs;
  inputs.parameters = std::move(parameters);
  inputs.material.friction = 0.0;
  inputs.patch = wide_patch();
  inputs.patch.extent_m = {100.0, 100.0};
  inputs.assets = {{kRecordingRole, table_of_recording(recording)}};
  inputs.seed = 5;
  return inputs;
}

/// The force along the motion divided by t̂, from 0.2 s on, when the texture has faded in.
std::vector<double> played_N(const RendererInputs& inputs, const Stroke& stroke) {
  constexpr double kRest_m_per_s = 0.010;
  const auto renderer = make_renderer(recorded_model(), inputs);
  const std::vector<RenderedTick> ticks = along_path(*renderer, samples_of(stroke), stroke.rate_Hz);
  std::vector<double> vibration_N{};
  for (auto i = static_cast<std::size_t>(0.2 * stroke.rate_Hz); i < ticks.size(); ++i) {
    EXPECT_EQ(ticks[i].wrench.force_N.y, 0.0);
    vibration_N.push_back(ticks[i].wrench.force_N.x *
                          std::hypot(stroke.speed_m_per_s, kRest_m_per_s) / stroke.speed_m_per_s);
  }
  return vibration_N;
}

/// A third of an octave of a recorded or a played force.
double third_N(const std::vector<double>& force_N, double rate_Hz, double centre_Hz) {
  return band_rms(force_N, rate_Hz, centre_Hz * std::pow(2.0, -1.0 / 6.0),
                  centre_Hz * std::pow(2.0, 1.0 / 6.0));
}

constexpr double kThirds_Hz[] = {10.0, 12.5,  16.0,  20.0,  25.0,  31.5,  40.0,  50.0, 63.0,
                                 80.0, 100.0, 125.0, 160.0, 200.0, 250.0, 315.0, 400.0};

// In one period of the vibration, 0.2 m, in which the lines of the played force are those of the tables.
TEST(Recorded, HasTheThirdOctavesOfTheRecordingAtItsSpeeds) {
  const TextureRecording recording{{noisy_stroke(0.05, 0.1, 1), noisy_stroke(0.1, 0.3, 2)}};
  for (const RecordedStroke& stroke : recording.strokes) {
    const double speed_m_per_s = stroke.speed_m_per_s();
    const std::vector<double> force_N =
        played_N(of_recording(recording), {.speed_m_per_s = speed_m_per_s,
                                           .duration_s = 0.2 + 0.2 / speed_m_per_s,
                                           .rate_Hz = 2000.0});
    for (const double centre_Hz : kThirds_Hz) {
      EXPECT_NEAR(20.0 * std::log10(third_N(force_N, 2000.0, centre_Hz) /
                                    third_N(stroke.force_N, kRecordedRate_Hz, centre_Hz)),
                  0.0, 0.5)
          << speed_m_per_s << ' ' << centre_Hz;
    }
  }
}

/// The frequency with the greatest power, weighted over its neighbours.
double peak_of_played_Hz(const std::vector<double>& signal, double rate_Hz) {
  const auto lines = real_spectrum(signal);
  std::size_t peak = 1;
  for (std::size_t k = 1; k < lines.size(); ++k) {
    if (std::norm(lines[k]) > std::norm(lines[peak])) peak = k;
  }
  double sum = 0.0;
  double weight = 0.0;
  for (std::size_t k = peak - 3; k <= peak + 3; ++k) {
    sum += static_cast<double>(k) * std::norm(lines[k]);
    weight += std::norm(lines[k]);
  }
  return sum / weight * rate_Hz / static_cast<double>(signal.size());
}

TextureRecording waves_at(double slow_m_per_s, double fast_m_per_s, double slow_N, double fast_N) {
  constexpr double kRecordedWave_m = 0.001;
  const auto wave = [](double amplitude_N) {
    return [amplitude_N](double path_m) {
      return amplitude_N * std::sin(2.0 * std::numbers::pi * path_m / kRecordedWave_m);
    };
  };
  return {{recorded_stroke(slow_m_per_s, 1.0, wave(slow_N)),
           recorded_stroke(fast_m_per_s, 1.0, wave(fast_N))}};
}

// Between 50 and 100 mm/s: the frequency follows the speed, and the amplitude is the geometric mean at √(50·100).
TEST(Recorded, KeepsTheWavelengthBetweenTheSpeedsAndInterpolatesTheLogarithmOfTheAmplitude) {
  const TextureRecording waves = waves_at(0.05, 0.1, 0.1, 0.4);
  const Stroke between{.speed_m_per_s = 0.07, .duration_s = 4.2};
  EXPECT_NEAR(peak_of_played_Hz(played_N(of_recording(waves), between), 1000.0), 70.0, 0.7);
  for (const auto& [speed_m_per_s, amplitude_N] :
       {std::pair{0.03, 0.1}, std::pair{0.05, 0.1}, std::pair{std::sqrt(0.005), 0.2},
        std::pair{0.05 * std::pow(2.0, 0.8125), 0.1 * std::pow(4.0, 0.8125)}, std::pair{0.1, 0.4},
        std::pair{0.15, 0.4}}) {
    const std::vector<double> force_N =
        played_N(of_recording(waves), {.speed_m_per_s = speed_m_per_s,
                                       .duration_s = 0.2 + 0.2 / speed_m_per_s,
                                       .rate_Hz = 2000.0});
    EXPECT_NEAR(band_rms(force_N, 2000.0) * std::numbers::sqrt2 / amplitude_N, 1.0, 0.03)
        << speed_m_per_s;
  }
}

// The way of the source: the lines of both speeds, 50 and 100 Hz, each with another amplitude, and nothing at 70 Hz.
TEST(Recorded, KeepsTheFrequenciesOfTheRecordingWithATemporalSpectrum) {
  const RendererInputs inputs =
      of_recording(waves_at(0.05, 0.1, 0.2, 0.2), {{"axis_of_spectrum", std::string("temporal")}});
  EXPECT_NEAR(
      peak_of_played_Hz(played_N(inputs, {.speed_m_per_s = 0.05, .duration_s = 4.2}), 1000.0), 50.0,
      0.5);
  EXPECT_NEAR(
      peak_of_played_Hz(played_N(inputs, {.speed_m_per_s = 0.1, .duration_s = 4.2}), 1000.0), 100.0,
      1.0);
  const auto between_N = played_N(inputs, {.speed_m_per_s = 0.07, .duration_s = 4.2});
  EXPECT_LT(band_rms(between_N, 1000.0, 65.0, 75.0), 1e-3);
}

TEST(Recorded, IsProportionalToThePowerOfTheNormalForce) {
  const TextureRecording waves = waves_at(0.05, 0.1, 0.1, 0.1);
  for (const double exponent : {0.0, 0.5, 1.0}) {
    const RendererInputs inputs = of_recording(waves, {{"force_exponent", exponent}});
    const auto firm_N = played_N(inputs, {.height_m = -0.002});    // 1 N
    const auto light_N = played_N(inputs, {.height_m = -0.0005});  // 0.25 N
    for (std::size_t i = 0; i < firm_N.size(); ++i) {
      ASSERT_NEAR(light_N[i], std::pow(0.25, exponent) * firm_N[i], 1e-9) << exponent;
    }
  }
  // A recording under 2 N is that of 1 N with half of the force.
  TextureRecording pressed = waves;
  for (RecordedStroke& stroke : pressed.strokes) {
    for (double& force_N : stroke.normal_N) force_N = 2.0;
    for (double& force_N : stroke.force_N) force_N *= 2.0;
  }
  const auto once_N = played_N(of_recording(waves), {});
  const auto pressed_N = played_N(of_recording(pressed), {});
  for (std::size_t i = 0; i < once_N.size(); ++i) ASSERT_NEAR(once_N[i], pressed_N[i], 1e-7);
}

TEST(Recorded, ActsAlongTheNormalOnRequest) {
  const RendererInputs inputs =
      of_recording(waves_at(0.05, 0.1, 0.1, 0.1), {{"axis", std::string("normal")}});
  const auto renderer = make_renderer(recorded_model(), inputs);
  const auto ticks = along_path(*renderer, samples_of({.duration_s = 2.2}), 1000.0);
  std::vector<double> normal_N{};
  for (std::size_t i = 200; i < ticks.size(); ++i) {
    EXPECT_EQ(ticks[i].wrench.force_N.x, 0.0);
    normal_N.push_back(ticks[i].wrench.force_N.z);
  }
  EXPECT_NEAR(band_rms(normal_N, 1000.0), 0.1 / std::numbers::sqrt2, 0.003);
  EXPECT_NEAR(peak_of_played_Hz(normal_N, 1000.0), 60.0, 0.6);
}

// Also where the hand has just stopped, with readings that vary about a place.
TEST(Recorded, IsThePlateAtRest) {
  for (const char* axis : {"motion", "normal"}) {
    for (const char* spectrum : {"spatial", "temporal"}) {
      const auto renderer = make_renderer(
          recorded_model(),
          of_recording(waves_at(0.05, 0.1, 0.1, 0.1),
                       {{"axis", std::string(axis)}, {"axis_of_spectrum", std::string(spectrum)}}));
      std::vector<ProbeState> path = samples_of({.duration_s = 0.5});
      const std::size_t stopped = path.size();
      add_rest(path, 60'000);
      const auto ticks = along_path(*renderer, path, 1000.0);
      double strongest_N = 0.0;
      for (std::size_t i = 0; i < path.size(); ++i) {
        const double texture_N = glm::length(ticks[i].wrench.force_N - glm::dvec3(0.0, 0.0, 1.0));
        if (i < stopped) strongest_N = std::max(strongest_N, texture_N);
        if (i <= stopped + 60) continue;
        ASSERT_LT(texture_N, 1e-15) << axis << ' ' << spectrum << ' ' << i;
      }
      EXPECT_GT(strongest_N, 0.05) << axis << ' ' << spectrum;
    }
  }
}

TEST(Recorded, IsTheSameAtOtherServoRatesInThirdsOfAnOctave) {
  const RendererInputs inputs =
      of_recording({{noisy_stroke(0.05, 0.1, 1), noisy_stroke(0.1, 0.3, 2)}});
  const Stroke slow{.speed_m_per_s = 0.08, .duration_s = 2.7, .rate_Hz = 1000.0};
  Stroke fast = slow;
  fast.rate_Hz = 4000.0;
  const auto slow_N = played_N(inputs, slow);
  const auto fast_N = played_N(inputs, fast);
  for (const double centre_Hz : {20.0, 40.0, 80.0, 160.0, 250.0}) {
    EXPECT_NEAR(
        20.0 * std::log10(third_N(slow_N, 1000.0, centre_Hz) / third_N(fast_N, 4000.0, centre_Hz)),
        0.0, 0.5)
        << centre_Hz;
  }
}

TEST(Recorded, RefusesASingleSpeedUnlessItIsAccepted) {
  const TextureRecording one = waves_at(0.05, 0.053, 0.1, 0.1);
  EXPECT_THAT(refusal_of<std::invalid_argument>(
                  [&] { make_renderer(recorded_model(), of_recording(one)); }),
              testing::AllOf(testing::HasSubstr("0.051 m/s"), testing::HasSubstr("second speed")));
  const auto force_N = played_N(of_recording(one, {{"single_speed", std::string("accepted")}}),
                                {.speed_m_per_s = 0.1, .duration_s = 4.2});
  EXPECT_NEAR(peak_of_played_Hz(force_N, 1000.0), 100.0, 1.0);
}

TEST(Recorded, RefusesATableThatItCannotRead) {
  RendererInputs inputs = of_recording(waves_at(0.05, 0.1, 0.1, 0.1));
  inputs.assets[kRecordingRole] = std::make_shared<const std::string>("a list of groceries\n");
  EXPECT_THAT(refusal_of<std::invalid_argument>([&] { make_renderer(recorded_model(), inputs); }),
              testing::HasSubstr("recording:1: the column stroke is missing"));
  inputs.asset_names[kRecordingRole] = "stimuli/wood.tsv";
  EXPECT_THAT(refusal_of<std::invalid_argument>([&] { make_renderer(recorded_model(), inputs); }),
              testing::StartsWith("stimuli/wood.tsv:1: the column stroke is missing"));
  inputs.assets.clear();
  EXPECT_THAT(refusal_of<std::invalid_argument>([&] { make_renderer(recorded_model(), inputs); }),
              testing::HasSubstr("needs the asset \"recording\""));
}

TEST(Recorded, HasTheBandOfItsWaves) {
  const RendererInputs inputs = of_recording(waves_at(0.05, 0.1, 0.1, 0.1));
  EXPECT_NEAR(band_Hz(recorded_model(), inputs, 0.06), 60.0, 1.0);
  RendererInputs temporal = inputs;
  temporal.parameters = {{"axis_of_spectrum", std::string("temporal")}};
  EXPECT_NEAR(band_Hz(recorded_model(), temporal, 0.06), 100.0, 2.0);
}

}  // namespace
}  // namespace asperity
