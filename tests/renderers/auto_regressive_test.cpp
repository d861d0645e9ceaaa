// Friction that varies along the path: its variance and spectrum, its limits, the hand at rest, and the values for a relief.

#include "renderers/models/auto_regressive.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/numbers/random.h"
#include "analysis/signals/spectrum.h"
#include "renderers/offline/along_path.h"
#include "tests/renderers/surfaces.h"
#include "tests/support/refusal.h"

namespace asperity {
namespace {

constexpr double kNodeLength_m = 1e-4;
constexpr double kFrictionSd = 0.06;
constexpr double kProcessA1 = 1.4562305898749055;
constexpr double kProcessA2 = -0.81;

/// With the law `rounded`, with which the whole force along the surface is that of one coefficient.
std::unique_ptr<ForceRenderer> varied(double friction, ParameterValues parameters = {},
                                      std::uint64_t seed = 11) {
  RendererInputs inputs;
  inputs.parameters = std::move(parameters);
  inputs.parameters["friction_law"] = std::string("rounded");
  inputs.material.friction = friction;
  inputs.patch = wide_patch();
  inputs.patch.extent_m = {100.0, 100.0};
  inputs.seed = seed;
  return make_renderer(auto_regressive_model(), inputs);
}

/// The effective friction on a stroke with 1 N on the plate, from 0.1 s on, when the texture has faded in.
std::vector<double> effective_friction(double friction, const Stroke& stroke,
                                       ParameterValues parameters = {}) {
  constexpr double kRest_m_per_s = 0.010;
  const auto renderer = varied(friction, std::move(parameters));
  std::vector<double> effective{};
  const std::vector<RenderedTick> ticks = along_path(*renderer, samples_of(stroke), stroke.rate_Hz);
  for (auto i = static_cast<std::size_t>(0.1 * stroke.rate_Hz); i < ticks.size(); ++i) {
    const glm::dvec3& force_N = ticks[i].wrench.force_N;
    EXPECT_EQ(force_N.z, 1.0);
    EXPECT_EQ(force_N.y, 0.0);
    effective.push_back(-force_N.x * std::hypot(stroke.speed_m_per_s, kRest_m_per_s) /
                        stroke.speed_m_per_s);
  }
  return effective;
}

double friction_mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double friction_variance(const std::vector<double>& values) {
  const double mean = friction_mean(values);
  double sum = 0.0;
  for (const double value : values) sum += (value - mean) * (value - mean);
  return sum / static_cast<double>(values.size());
}

// At 10 mm/s a node is 10 ticks of 1 kHz.
constexpr Stroke kSlowFriction{.speed_m_per_s = 0.01, .duration_s = 1000.0, .rate_Hz = 1000.0};

// The variance between the nodes of a linear interpolation is (2 + ρ₁)/3 of that at the nodes, ρ₁ = a₁/(1 − a₂).
constexpr double kFrictionBetweenNodes = (2.0 + kProcessA1 / (1.0 - kProcessA2)) / 3.0;

// Of 100 000 nodes with Σρ_k² = 5: 4 % is four standard errors.
TEST(AutoRegressive, VariesAboutTheFrictionOfTheMaterialWithItsStandardDeviation) {
  const std::vector<double> effective = effective_friction(1.0, kSlowFriction);
  EXPECT_NEAR(friction_mean(effective), 1.0, 0.002);
  EXPECT_NEAR(friction_variance(effective) / (kFrictionSd * kFrictionSd * kFrictionBetweenNodes),
              1.0, 0.04);
}

TEST(AutoRegressive, HasTheSpectrumOfItsCoefficients) {
  // g² = var·(1 + a₂)·((1 − a₂)² − a₁²)/(1 − a₂)
  const double innovation = kFrictionSd * kFrictionSd * (1.0 + kProcessA2) *
                            ((1.0 - kProcessA2) * (1.0 - kProcessA2) - kProcessA1 * kProcessA1) /
                            (1.0 - kProcessA2);
  for (const double rate_Hz : {1000.0, 4000.0}) {
    const Stroke stroke{.speed_m_per_s = 0.06, .duration_s = 120.0, .rate_Hz = rate_Hz};
    const std::vector<double> effective = effective_friction(1.0, stroke);
    const double node_s = kNodeLength_m / stroke.speed_m_per_s;
    for (const double centre_Hz : {40.0, 50.0, 63.0, 80.0, 100.0, 125.0}) {
      const double low_Hz = centre_Hz * std::pow(2.0, -1.0 / 6.0);
      const double high_Hz = centre_Hz * std::pow(2.0, 1.0 / 6.0);
      constexpr int kParts = 200;
      double expected = 0.0;
      for (int part = 0; part < kParts; ++part) {
        const double f_Hz = low_Hz + (part + 0.5) * (high_Hz - low_Hz) / kParts;
        const double half = std::numbers::pi * f_Hz * node_s;
        const std::complex<double> z = std::polar(1.0, -2.0 * half);
        expected += 2.0 * innovation * node_s /
                    std::norm(1.0 - kProcessA1 * z - kProcessA2 * z * z) *
                    std::pow(std::sin(half) / half, 4) * (high_Hz - low_Hz) / kParts;
      }
      const double measured = std::pow(band_rms(effective, rate_Hz, low_Hz, high_Hz), 2);
      EXPECT_NEAR(10.0 * std::log10(measured / expected), 0.0, 0.6) << rate_Hz << ' ' << centre_Hz;
    }
  }
}

// E max(0, μ + s·ξ) = μ + s·φ(μ/s) − μ·Φ(−μ/s).
TEST(AutoRegressive, IsNeverNegativeWhichRaisesItsMean) {
  constexpr double kSlippery = 0.05;
  constexpr double kWide = 0.2;
  const std::vector<double> effective =
      effective_friction(kSlippery, kSlowFriction, {{"friction_sd", kWide}});
  EXPECT_GE(*std::min_element(effective.begin(), effective.end()), -1e-12);
  const double s = kWide * std::sqrt(kFrictionBetweenNodes);
  const double phi =
      std::exp(-0.5 * kSlippery * kSlippery / s / s) / std::sqrt(2.0 * std::numbers::pi);
  const double tail = 0.5 * std::erfc(kSlippery / s / std::numbers::sqrt2);
  const double expected = kSlippery + s * phi - kSlippery * tail;
  EXPECT_GT(expected, 0.09);
  EXPECT_NEAR(friction_mean(effective) / expected, 1.0, 0.04);
}

TEST(AutoRegressive, IsNeverAboveTwo) {
  const std::vector<double> effective =
      effective_friction(1.0, {.speed_m_per_s = 0.01, .duration_s = 60.0}, {{"friction_sd", 2.0}});
  EXPECT_NEAR(*std::max_element(effective.begin(), effective.end()), 2.0, 1e-12);
  // A material beyond it keeps its friction.
  const std::vector<double> plain =
      effective_friction(2.5, {.duration_s = 0.3}, {{"friction_sd", 0.0}});
  EXPECT_NEAR(plain.back(), 2.5, 1e-12);
}

TEST(AutoRegressive, GrowsWithTheNormalForce) {
  const auto one = varied(0.2);
  const auto other = varied(0.2);
  const auto firm = along_path(*one, samples_of({.height_m = -0.002}), 1000.0);
  const auto light = along_path(*other, samples_of({.height_m = -0.0005}), 1000.0);
  for (std::size_t i = 0; i < firm.size(); ++i) {
    ASSERT_NEAR(light[i].wrench.force_N.x, 0.25 * firm[i].wrench.force_N.x, 1e-12) << i;
  }
}

// The texture is what differs from the same plate without it; also where the hand has just stopped, with a velocity that
// varies about zero.
TEST(AutoRegressive, IsThePlateAtRest) {
  const auto renderer = varied(0.2);
  const auto plate = varied(0.2, {{"friction_sd", 0.0}});
  std::vector<ProbeState> path{probe_at({0.0, 0.0, -0.002})};
  add_rest(path, 30'000);
  const std::size_t stroke_from = path.size();
  for (ProbeState probe : samples_of({.from_x_m = path.back().position_m.x, .duration_s = 0.5})) {
    probe.time_ns = path.back().time_ns + 1'000'000;
    path.push_back(probe);
  }
  const std::size_t stroke_to = path.size();
  add_rest(path, 30'000);
  const auto felt = along_path(*renderer, path, 1000.0);
  const auto plain = along_path(*plate, path, 1000.0);
  double strongest_N = 0.0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const double texture_N = std::abs(felt[i].wrench.force_N.x - plain[i].wrench.force_N.x);
    if (i >= stroke_from && i < stroke_to) {
      strongest_N = std::max(strongest_N, texture_N);
    } else if (i < stroke_from || i > stroke_to + 60) {
      ASSERT_EQ(texture_N, 0.0) << i;
    }
  }
  EXPECT_GT(strongest_N, 0.5 * kFrictionSd);
}

TEST(AutoRegressive, IsTheSameForTheSameSeedAndPath) {
  const std::vector<ProbeState> path = samples_of({.duration_s = 0.3});
  const auto one = varied(0.2);
  const auto a = along_path(*one, path, 1000.0);
  const auto again = along_path(*one, path, 1000.0);
  const auto other = along_path(*varied(0.2, {}, 12), path, 1000.0);
  bool differs = false;
  for (std::size_t i = 0; i < path.size(); ++i) {
    ASSERT_EQ(a[i].wrench.force_N, again[i].wrench.force_N) << i;
    differs = differs || a[i].wrench.force_N != other[i].wrench.force_N;
  }
  EXPECT_TRUE(differs);
}

TEST(AutoRegressive, RefusesAProcessThatIsNotStationary) {
  for (const ParameterValues& values :
       {ParameterValues{{"coefficient_1", 1.0}, {"coefficient_2", 0.0}},
        ParameterValues{{"coefficient_1", 0.5}, {"coefficient_2", -1.0}},
        ParameterValues{{"coefficient_4", 1.2}}}) {
    EXPECT_THAT(refusal_of<std::invalid_argument>([&] { varied(0.2, values); }),
                testing::HasSubstr("grows without limit"));
    const ModelDeclaration declaration = auto_regressive_model().declaration;
    EXPECT_TRUE(declaration.conflict_among(complete_values(declaration, values)));
  }
}

// A wave of amplitude A and length L has the slope 2πA/L; over a step d its chords have sinc(d/L) of it.
TEST(AutoRegressive, TakesTheSlopesOfAReliefFromItsRows) {
  constexpr double kAmplitude_m = 1e-4;
  constexpr double kLength_m = 2e-3;
  const auto field = grating(
      {.amplitude_m = kAmplitude_m, .wavelength_m = kLength_m, .pitch_m = 5e-5, .rows = 80});
  const ParameterValues values = autoregression_of_relief(*field);
  const double part = std::numbers::pi * kNodeLength_m / kLength_m;
  EXPECT_NEAR(
      number_of(values, "friction_sd"),
      std::numbers::sqrt2 * std::numbers::pi * kAmplitude_m / kLength_m * std::sin(part) / part,
      0.005);
  EXPECT_EQ(number_of(values, "noise_length_m"), kNodeLength_m);
  const double a1 = number_of(values, "coefficient_1");
  const double a2 = number_of(values, "coefficient_2");
  const double theta = std::acos(0.5 * a1 / std::sqrt(-a2));
  EXPECT_NEAR(theta / (2.0 * part), 1.0, 0.03);  // of 4 periods
  EXPECT_EQ(number_of(values, "coefficient_3"), 0.0);
}

// Its own output: recorded, and estimated, it gives its own parameters.
TEST(AutoRegressive, RecoversItsOwnCoefficientsFromAProfile) {
  // One node per tick without the low-pass: the recursion itself.
  Random random(5);
  std::vector<double> profile{0.0, 0.0};
  while (profile.size() < 40'000) {
    profile.push_back(kProcessA1 * profile.back() + kProcessA2 * profile[profile.size() - 2] +
                      0.01 * random.normal());
  }
  const std::vector<std::vector<double>> segments{profile};
  const ParameterValues values = autoregression_of_profiles(segments, kNodeLength_m);
  const double tolerance = 3.0 / std::sqrt(40'000.0) + 0.002;  // and the poles moved by 0.1 %
  EXPECT_NEAR(number_of(values, "coefficient_1"), kProcessA1, tolerance);
  EXPECT_NEAR(number_of(values, "coefficient_2"), kProcessA2, tolerance);
  EXPECT_NEAR(number_of(values, "friction_sd"),
              0.01 * std::sqrt((1.0 - kProcessA2) / (1.0 + kProcessA2) /
                               ((1.0 - kProcessA2) * (1.0 - kProcessA2) - kProcessA1 * kProcessA1)),
              0.002);
}

// A drag of 0.3 times a normal force that varies, with the process on it, at two speeds and with a trend.
TEST(AutoRegressive, RecoversItsCoefficientsFromARecordedForce) {
  TextureRecording recording{};
  Random random(6);
  for (const double speed_m_per_s : {0.05, 0.1}) {
    const int per_node = speed_m_per_s < 0.1 ? 2 : 1;
    RecordedStroke stroke{};
    std::vector<double> m{0.0, 0.0};
    for (int i = 0; i < 30'000 * per_node; ++i) {
      if (i % per_node == 0) {
        m.push_back(kProcessA1 * m.back() + kProcessA2 * m[m.size() - 2] + 0.01 * random.normal());
      }
      const double path_m = i * kNodeLength_m / per_node;
      stroke.time_s.push_back(path_m / speed_m_per_s);
      stroke.path_m.push_back(path_m);
      stroke.normal_N.push_back(1.0 + 0.5 * std::sin(0.003 * i));
      stroke.force_N.push_back(stroke.normal_N.back() * (0.3 + 0.05 * path_m + m.back()));
    }
    recording.strokes.push_back(stroke);
  }
  const ParameterValues values = autoregression_of_recording(recording);
  const double tolerance = 3.0 / std::sqrt(60'000.0) + 0.002;  // and the poles moved by 0.1 %
  EXPECT_NEAR(number_of(values, "coefficient_1"), kProcessA1, tolerance);
  EXPECT_NEAR(number_of(values, "coefficient_2"), kProcessA2, tolerance);
  EXPECT_NEAR(number_of(values, "noise_length_m"), kNodeLength_m, 1e-12);
  EXPECT_NEAR(number_of(values, "friction_sd"),
              0.01 * std::sqrt((1.0 - kProcessA2) / (1.0 + kProcessA2) /
                               ((1.0 - kProcessA2) * (1.0 - kProcessA2) - kProcessA1 * kProcessA1)),
              0.002);
}

TEST(AutoRegressive, OfALevelReliefIsThePlate) {
  const ParameterValues values = autoregression_of_relief(*level(0.0F));
  EXPECT_EQ(number_of(values, "friction_sd"), 0.0);
  EXPECT_NO_THROW(varied(0.2, values));
}

}  // namespace
}  // namespace asperity
