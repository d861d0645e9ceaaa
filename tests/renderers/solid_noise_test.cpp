// Solid noise: the lattice, smoothness, strength and directions of its heights, and the work of its force.

#include "renderers/models/solid_noise.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/numbers/random.h"
#include "analysis/signals/spectrum.h"
#include "renderers/force/gradient_noise.h"
#include "renderers/offline/along_path.h"
#include "tests/renderers/surfaces.h"

namespace asperity {
namespace {

TEST(GradientNoise, IsZeroAtTheLattice) {
  const GradientNoise noise(Random(3));
  for (int i = -3; i < 4; ++i) {
    for (int j = -3; j < 4; ++j) EXPECT_EQ(noise.at({i, j, i - 2 * j}).value, 0.0);
  }
}

TEST(GradientNoise, HasTheGradientOfItsValues) {
  const GradientNoise noise(Random(3));
  Random places(8);
  constexpr double kStep = 1e-5;
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 place(8.0 * places.uniform() - 4.0, 8.0 * places.uniform() - 4.0,
                           8.0 * places.uniform() - 4.0);
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 ahead = place;
      glm::dvec3 behind = place;
      ahead[axis] += kStep;
      behind[axis] -= kStep;
      EXPECT_NEAR(noise.at(place).gradient[axis],
                  (noise.at(ahead).value - noise.at(behind).value) / (2.0 * kStep), 1e-7);
    }
  }
}

// The second derivatives of two sides of a face of the lattice are the same; the third ones are not.
TEST(GradientNoise, IsTwiceContinuouslyDifferentiable) {
  const GradientNoise noise(Random(3));
  Random places(9);
  constexpr double kStep = 1e-5;
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 at(std::floor(10.0 * places.uniform()), 5.0 * places.uniform(),
                        5.0 * places.uniform());
    const glm::dvec3 step(kStep, 0.0, 0.0);
    const glm::dvec3 before = (noise.at(at).gradient - noise.at(at - step).gradient) / kStep;
    const glm::dvec3 after = (noise.at(at + step).gradient - noise.at(at).gradient) / kStep;
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(before[axis], after[axis], 3e-3);
  }
}

TEST(GradientNoise, HasItsMeanSquareOverSpace) {
  double sum = 0.0;
  constexpr int kPlaces = 400'000;
  Random places(10);
  const GradientNoise noise(Random(4));
  for (int i = 0; i < kPlaces; ++i) {
    const glm::dvec3 place(1e4 * places.uniform(), 1e4 * places.uniform(), 1e4 * places.uniform());
    const double value = noise.at(place).value;
    sum += value * value;
  }
  EXPECT_NEAR(std::sqrt(sum / kPlaces) / GradientNoise::kRms, 1.0, 0.005);
}

TEST(GradientNoise, IsTheSameForEver) {
  const NoiseAtPlace noise = GradientNoise(Random(20261123)).at({1.25, -7.5, 1000.375});
  EXPECT_EQ(noise.value, GradientNoise(Random(20261123)).at({1.25, -7.5, 1000.375}).value);
  EXPECT_NE(noise.value, GradientNoise(Random(20261124)).at({1.25, -7.5, 1000.375}).value);
}

constexpr double kUnderRelief_m = 0.002;

std::unique_ptr<ForceRenderer> relief_of_noise(ParameterValues parameters = {},
                                               std::uint64_t seed = 5) {
  RendererInputs inputs;
  inputs.parameters = std::move(parameters);
  inputs.material.friction = 0.0;
  inputs.patch = wide_patch();
  inputs.patch.extent_m = {100.0, 100.0};
  inputs.seed = seed;
  return make_renderer(solid_noise_model(), inputs);
}

/// The heights along a straight line through the centre, in samples of 20 µm.
std::vector<double> heights_along(double angle_rad, std::size_t samples,
                                  const ParameterValues& parameters, std::uint64_t seed) {
  const auto renderer = relief_of_noise(parameters, seed);
  std::vector<double> heights_m{};
  ProbeState probe{};
  renderer->reset(probe);
  for (std::size_t i = 0; i < samples; ++i) {
    const double along_m = 2e-5 * static_cast<double>(i);
    probe.position_m = {along_m * std::cos(angle_rad), along_m * std::sin(angle_rad),
                        -kUnderRelief_m};
    heights_m.push_back(renderer->tick(probe, kTick_s).wrench.force_N.z / 500.0 - kUnderRelief_m);
  }
  return heights_m;
}

double rms_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

// 20 planes of 1 m each, at different places of the lattice: 20 000 cells.
TEST(SolidNoise, HasItsStrengthOverPlanes) {
  for (const double octaves : {1.0, 3.0}) {
    double mean_square = 0.0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const double rms_m = rms_of(heights_along(0.4, 50'000, {{"octaves", octaves}}, seed));
      mean_square += rms_m * rms_m / 20.0;
    }
    const double sum = octaves == 1.0 ? 1.0 : 1.0 + 0.25 + 0.0625;
    EXPECT_NEAR(std::sqrt(mean_square) / (50e-6 * GradientNoise::kRms * std::sqrt(sum)), 1.0, 0.03)
        << octaves;
  }
}

TEST(SolidNoise, IsAsStrongInEveryDirection) {
  std::vector<double> rms_m{};
  for (int direction = 0; direction < 8; ++direction) {
    double mean_square = 0.0;
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      const double own_m =
          rms_of(heights_along(direction * std::numbers::pi / 8.0, 50'000, {}, 100 * seed + 7));
      mean_square += own_m * own_m / 10.0;
    }
    rms_m.push_back(std::sqrt(mean_square));
  }
  const auto [least, greatest] = std::minmax_element(rms_m.begin(), rms_m.end());
  EXPECT_LT(*greatest / *least, 1.10);
}

TEST(SolidNoise, KeepsItsPowerInItsBand) {
  for (const double octaves : {1.0, 3.0}) {
    const std::vector<double> heights_m = heights_along(0.3, 50'000, {{"octaves", octaves}}, 3);
    const double all_m = rms_of(heights_m);
    const double beyond_m =
        band_rms(heights_m, 1.0 / 2e-5, std::pow(2.0, octaves) / 1e-3, 25'000.0);
    EXPECT_LT(beyond_m * beyond_m / (all_m * all_m), 0.02) << octaves;
  }
}

TEST(SolidNoise, HasTheSameHeightWheneverAPlaceIsFelt) {
  const auto renderer = relief_of_noise();
  const ProbeState here = probe_at({0.0123, -0.0045, -kUnderRelief_m});
  const double first_N = answer(*renderer, here).wrench.force_N.z;
  for (const ProbeState& probe : samples_of({.duration_s = 0.2})) renderer->tick(probe, kTick_s);
  EXPECT_EQ(renderer->tick(here, kTick_s).wrench.force_N.z, first_N);
  EXPECT_EQ(answer(*relief_of_noise(), here).wrench.force_N.z, first_N);
}

TEST(SolidNoise, HasTheReliefOfItsNumberWhateverTheSeed) {
  const auto height = [](double relief, std::uint64_t seed) {
    return answer(*relief_of_noise({{"relief", relief}}, seed),
                  probe_at({0.0123, -0.0045, -kUnderRelief_m}))
        .wrench.force_N.z;
  };
  EXPECT_EQ(height(7.0, 1), height(7.0, 2));
  EXPECT_NE(height(7.0, 1), height(8.0, 1));
  EXPECT_NE(height(0.0, 1), height(0.0, 2));
}

TEST(SolidNoise, DoesNotChangeWithDepth) {
  const auto renderer = relief_of_noise();
  const double shallow_N =
      answer(*renderer, probe_at({0.01, 0.003, -kUnderRelief_m})).wrench.force_N.z;
  const double deep_N =
      answer(*renderer, probe_at({0.01, 0.003, -2.0 * kUnderRelief_m})).wrench.force_N.z;
  EXPECT_NEAR(deep_N - shallow_N, 500.0 * kUnderRelief_m, 1e-12);
}

}  // namespace
}  // namespace asperity
