// Filtered noise on the path of the hand: its variance, correlation and spectrum, and the hand at rest.

#include "renderers/models/filtered_noise.h"

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

namespace asperity {
namespace {

constexpr double kColourLength_m = 1e-4;
constexpr double kColourSd_N = 0.05;

std::unique_ptr<ForceRenderer> coloured(ParameterValues parameters = {}, std::uint64_t seed = 11) {
  RendererInputs inputs;
  inputs.parameters = std::move(parameters);
  inputs.material.friction = 0.0;
  inputs.patch = wide_patch();
  inputs.patch.extent_m = {100.0, 100.0};
  inputs.seed = seed;
  return make_renderer(filtered_noise_model(), inputs);
}

/// The force along the motion of a stroke with 1 N on the plate, divided by its t̂.
std::vector<double> along_motion_N(const Stroke& stroke, ParameterValues parameters) {
  constexpr double kRest_m_per_s = 0.010;
  const auto renderer = coloured(std::move(parameters));
  std::vector<double> noise_N{};
  for (const RenderedTick& tick : along_path(*renderer, samples_of(stroke), stroke.rate_Hz)) {
    EXPECT_EQ(tick.wrench.force_N.z, 1.0);
    EXPECT_EQ(tick.wrench.force_N.y, 0.0);
    noise_N.push_back(tick.wrench.force_N.x * std::hypot(stroke.speed_m_per_s, kRest_m_per_s) /
                      stroke.speed_m_per_s);
  }
  return noise_N;
}

double mean_product(const std::vector<double>& a, std::size_t lag) {
  double sum = 0.0;
  for (std::size_t i = 0; i + lag < a.size(); ++i) sum += a[i] * a[i + lag];
  return sum / static_cast<double>(a.size() - lag);
}

struct Poles {
  double r = 0.0;
  double theta = 0.0;  // of two poles
  bool is_pair = false;

  /// The spectrum at ω per node, relative to a white noise of the same variance.
  double colour(double omega) const {
    const double a1 = is_pair ? 2.0 * r * std::cos(theta) : r;
    const double a2 = is_pair ? -r * r : 0.0;
    const std::complex<double> z = std::polar(1.0, -omega);
    double power = 0.0;  // Σ h_i², from the recursion itself, until nothing is left of it
    double before = 0.0;
    double last = 1.0;
    for (int i = 0; i < 1000; ++i) {
      power += last * last;
      const double next = a1 * last + a2 * before;
      before = last;
      last = next;
    }
    return 1.0 / std::norm(1.0 - a1 * z - a2 * z * z) / power;
  }
};

/// The power in a third of an octave of the interpolated noise.
double expected_power(const Poles& poles, double centre_Hz, double speed_m_per_s) {
  const double node_s = kColourLength_m / speed_m_per_s;
  const double low_Hz = centre_Hz * std::pow(2.0, -1.0 / 6.0);
  const double high_Hz = centre_Hz * std::pow(2.0, 1.0 / 6.0);
  constexpr int kParts = 100;
  double power = 0.0;
  for (int part = 0; part < kParts; ++part) {
    const double f_Hz = low_Hz + (part + 0.5) * (high_Hz - low_Hz) / kParts;
    const double half = std::numbers::pi * f_Hz * node_s;
    power += 2.0 * kColourSd_N * kColourSd_N * node_s * poles.colour(2.0 * half) *
             std::pow(std::sin(half) / half, 4) * (high_Hz - low_Hz) / kParts;
  }
  return power;
}

double third_octave_power(const std::vector<double>& signal, double rate_Hz, double centre_Hz) {
  return std::pow(band_rms(signal, rate_Hz, centre_Hz * std::pow(2.0, -1.0 / 6.0),
                           centre_Hz * std::pow(2.0, 1.0 / 6.0)),
                  2);
}

double decibels_of(double power_ratio) { return 10.0 * std::log10(power_ratio); }

// At 10 mm/s a node is 10 ticks of 1 kHz; 600 s have 60 000 nodes.
constexpr Stroke kSlowly{.speed_m_per_s = 0.01, .duration_s = 600.0, .rate_Hz = 1000.0};

TEST(FilteredNoise, HasItsVarianceAndItsAutocorrelation) {
  for (const double r : {0.0, 0.5, 0.8}) {
    const std::vector<double> noise_N = along_motion_N(kSlowly, {{"pole_radius", r}});
    const double variance = kColourSd_N * kColourSd_N;
    // Of 60 000 nodes with a correlation length of (1 + r²)/(1 − r²): 3 % is four standard errors at r = 0.8.
    EXPECT_NEAR(mean_product(noise_N, 0) / variance, (2.0 + r) / 3.0, 0.03) << r;
    for (const int k : {1, 2, 3}) {
      // Between nodes: the mean over the place between them of the products of both interpolations.
      const double expected =
          (4.0 * std::pow(r, k) + std::pow(r, k - 1) + std::pow(r, k + 1)) / 6.0;
      EXPECT_NEAR(mean_product(noise_N, static_cast<std::size_t>(10 * k)) / variance, expected,
                  0.03)
          << r << ' ' << k;
    }
  }
}

TEST(FilteredNoise, HasTheSpectrumOfItsPoles) {
  const double theta = 2.0 * std::numbers::pi * kColourLength_m / 8e-4;
  const std::vector<std::pair<ParameterValues, Poles>> filters{
      {{{"pole_radius", 0.8}}, {.r = 0.8}},
      {{{"pole_radius", 0.5}}, {.r = 0.5}},
      {{{"pole_radius", 0.9}, {"peak_wavelength_m", 8e-4}},
       {.r = 0.9, .theta = theta, .is_pair = true}}};
  for (const auto& [parameters, poles] : filters) {
    for (const double rate_Hz : {1000.0, 4000.0}) {
      const Stroke stroke{.speed_m_per_s = 0.06, .duration_s = 120.0, .rate_Hz = rate_Hz};
      const std::vector<double> noise_N = along_motion_N(stroke, parameters);
      // v/4λ_n is 150 Hz.
      for (const double centre_Hz : {40.0, 50.0, 63.0, 80.0, 100.0, 125.0}) {
        EXPECT_NEAR(decibels_of(third_octave_power(noise_N, rate_Hz, centre_Hz) /
                                expected_power(poles, centre_Hz, stroke.speed_m_per_s)),
                    0.0, 0.6)
            << poles.r << ' ' << rate_Hz << ' ' << centre_Hz;
      }
    }
  }
}

TEST(FilteredNoise, HalvesItsPowerAtTheFrequencyOfThePole) {
  const double r = 0.8;
  const double omega = std::acos((4.0 * r - 1.0 - r * r) / (2.0 * r));
  const Poles pole{.r = r};
  EXPECT_NEAR(pole.colour(omega) / pole.colour(0.0), 0.5, 1e-9);
}

TEST(FilteredNoise, IsWeakerUnderALightTouch) {
  const Stroke firm{.height_m = -0.002, .duration_s = 0.5};    // 1 N
  const Stroke light{.height_m = -0.0005, .duration_s = 0.5};  // 0.25 N of 0.5 N
  const auto one = coloured();
  const auto other = coloured();
  const auto strong = along_path(*one, samples_of(firm), 1000.0);
  const auto weak = along_path(*other, samples_of(light), 1000.0);
  double largest_N = 0.0;
  for (std::size_t i = 0; i < strong.size(); ++i) {
    ASSERT_NEAR(weak[i].wrench.force_N.x, 0.5 * strong[i].wrench.force_N.x, 1e-12) << i;
    largest_N = std::max(largest_N, std::abs(strong[i].wrench.force_N.x));
  }
  EXPECT_GT(largest_N, 0.5 * kColourSd_N);
}

TEST(FilteredNoise, IsThePlateAtRest) {
  const auto renderer = coloured();
  Random jitter(4);
  ProbeState probe = probe_at({0.001, 0.002, -0.002});
  renderer->reset(probe);
  for (int tick = 0; tick < 60'000; ++tick) {
    probe.time_ns += 1'000'000;
    probe.position_m.x = 0.001 + 1e-5 * (static_cast<double>(jitter.below(3)) - 1.0);
    probe.velocity_m_per_s = {0.02, 0.0, 0.0};
    ASSERT_EQ(renderer->tick(probe, kTick_s).wrench.force_N, glm::dvec3(0.0, 0.0, 1.0)) << tick;
  }
}

TEST(FilteredNoise, IsTheSameForTheSameSeedAndPath) {
  const std::vector<ProbeState> path = samples_of({.duration_s = 0.3});
  const auto one = coloured();
  const auto a = along_path(*one, path, 1000.0);
  const auto again = along_path(*one, path, 1000.0);
  const auto other = along_path(*coloured({}, 12), path, 1000.0);
  bool differs = false;
  for (std::size_t i = 0; i < path.size(); ++i) {
    ASSERT_EQ(a[i].wrench.force_N, again[i].wrench.force_N) << i;
    differs = differs || a[i].wrench.force_N != other[i].wrench.force_N;
  }
  EXPECT_TRUE(differs);
}

// Without the stationary start, a filter of r = 0.999 would have 4 % of its variance after 2 mm.
TEST(FilteredNoise, IsStationaryFromTheFirstNodeOn) {
  double mean_square = 0.0;
  constexpr int kSeeds = 400;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const auto renderer = coloured({{"pole_radius", 0.999}}, seed);
    const std::vector<ProbeState> path = samples_of({.speed_m_per_s = 0.1, .duration_s = 0.02});
    const double last_N = along_path(*renderer, path, 1000.0).back().wrench.force_N.x;
    mean_square += last_N * last_N / kSeeds;
  }
  EXPECT_NEAR(std::sqrt(mean_square) / kColourSd_N, 1.0, 0.15);  // four standard errors
}

TEST(FilteredNoise, RefusesAPeakFinerThanItsNoise) {
  EXPECT_THROW(coloured({{"peak_wavelength_m", 1.5e-4}}), std::invalid_argument);
}

}  // namespace
}  // namespace asperity
