// The map of normals: the frameworks' numbers, and the physical slope.

#include "renderers/models/normal_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "renderers/models/sinusoid.h"
#include "tests/renderers/surfaces.h"

namespace asperity {
namespace {

constexpr double kMap_N_per_m = 500.0;

RendererInputs map_inputs(std::shared_ptr<const HeightField> field, ParameterValues parameters) {
  RendererInputs inputs;
  inputs.parameters = std::move(parameters);
  inputs.material = {.stiffness_N_per_m = kMap_N_per_m, .friction = 0.0};
  inputs.patch = wide_patch();
  inputs.height_field = std::move(field);
  return inputs;
}

glm::dvec3 map_N(const RendererInputs& inputs, const glm::dvec3& position_m) {
  return answer(*make_renderer(normal_map_model(), inputs), probe_at(position_m)).wrench.force_N;
}

/// 52 columns and 52 rows of 1 mm whose grey levels rise by 5 with each column, or each row upwards: 0 to 255.
std::shared_ptr<const HeightField> ramp_along_x(float rise_m = 1e-5F) {
  std::vector<float> heights_m(52 * 52);
  for (std::size_t i = 0; i < heights_m.size(); ++i) {
    heights_m[i] = rise_m * static_cast<float>(i % 52);
  }
  return std::make_shared<const HeightField>(HeightField::Grid{52, 52, 1e-3}, heights_m);
}

std::shared_ptr<const HeightField> ramp_along_y() {
  std::vector<float> heights_m(52 * 52);
  for (std::size_t i = 0; i < heights_m.size(); ++i) {
    heights_m[i] = 1e-5F * static_cast<float>(51 - i / 52);  // the first row is the top
  }
  return std::make_shared<const HeightField>(HeightField::Grid{52, 52, 1e-3}, heights_m);
}

// The neighbours differ by 10 levels: (−0.1, 0, 1)/1.004988 = (−0.0995037, 0, 0.995037). Stored: ⌊128 − 12.637⌋ = 115 and
// ⌊128 + 126.370⌋ = 254, read as −13/127 and 126/127: a slope of 13/126.
TEST(NormalMap, HasTheStoredNormalOfTheFramework) {
  RendererInputs inputs = map_inputs(ramp_along_x(), {});
  inputs.patch.tiling = Tiling::bounded;
  const glm::dvec3 force_N = map_N(inputs, {0.0003, 0.0004, -0.002});
  EXPECT_NEAR(force_N.x / force_N.z, -13.0 / 126.0, 1e-12);
  EXPECT_EQ(force_N.y, 0.0);
  inputs.height_field = ramp_along_y();
  const glm::dvec3 upwards_N = map_N(inputs, {0.0003, 0.0004, -0.002});
  EXPECT_NEAR(upwards_N.y / upwards_N.z, -13.0 / 126.0, 1e-12);
  EXPECT_EQ(upwards_N.x, 0.0);
}

TEST(NormalMap, IsNotRoundedWithManyBits) {
  RendererInputs inputs = map_inputs(ramp_along_x(), {{"bits", 24.0}});
  inputs.patch.tiling = Tiling::bounded;
  const glm::dvec3 force_N = map_N(inputs, {0.0003, 0.0004, -0.002});
  EXPECT_NEAR(force_N.x / force_N.z, -0.1, 1e-6);
}

TEST(NormalMap, DoesNotDependOnTheHeightOfTheReliefInGreyLevels) {
  RendererInputs inputs = map_inputs(ramp_along_x(), {});
  const glm::dvec3 low_N = map_N(inputs, {0.0003, 0.0, -0.002});
  inputs.height_field = ramp_along_x(1e-3F);
  EXPECT_EQ(map_N(inputs, {0.0003, 0.0, -0.002}), low_N);
}

// White squares of two by two texels on black: the steepest slopes that a picture has, 2.55 along both axes.
TEST(NormalMap, IsFiniteOnTheSteepestPictureWithTheFewestBits) {
  std::vector<float> heights_m(16 * 16);
  for (std::size_t i = 0; i < heights_m.size(); ++i) {
    heights_m[i] = (i % 16) % 4 < 2 && (i / 16) % 4 < 2 ? 1e-4F : 0.0F;
  }
  const auto checkers =
      std::make_shared<const HeightField>(HeightField::Grid{16, 16, 1e-3}, heights_m);
  const auto renderer = make_renderer(normal_map_model(), map_inputs(checkers, {{"bits", 4.0}}));
  for (int place = 0; place < 1000; ++place) {
    const glm::dvec3 at_m{0.7e-4 * place, 1.3e-4 * place, -0.002};
    EXPECT_NEAR(glm::length(answer(*renderer, probe_at(at_m)).wrench.force_N), kMap_N_per_m * 0.002,
                1e-12)
        << place;
  }
}

TEST(NormalMap, InterpolatesTheStoredComponents) {
  // Bounded: the last texel's right neighbour is itself, 5 levels: (−0.05, 0, 1)/1.001249: ⌊128 − 6.342⌋ = 121, read −7/127;
  // ⌊128 + 126.842⌋ = 254. A quarter of the way from the last but one (−13/127, 126/127): slope (0.75·13 + 0.25·7)/126.
  RendererInputs inputs = map_inputs(ramp_along_x(), {});
  inputs.patch.tiling = Tiling::bounded;
  const glm::dvec3 force_N = map_N(inputs, {(24.5 + 0.25) * 1e-3, 0.0, -0.002});
  EXPECT_NEAR(force_N.x / force_N.z, -(0.75 * 13.0 + 0.25 * 7.0) / 126.0, 1e-9);
}

TEST(NormalMap, ContinuesAccordingToTheTiling) {
  RendererInputs inputs = map_inputs(ramp_along_x(), {{"bits", 24.0}});
  const auto slope = [&](Tiling tiling, double column) {
    inputs.patch.tiling = tiling;
    const glm::dvec3 force_N = map_N(inputs, {(column - 25.5) * 1e-3, 0.0, -0.002});
    return -force_N.x / force_N.z;
  };
  EXPECT_NEAR(slope(Tiling::bounded, 70.0), 0.0, 1e-9);
  EXPECT_NEAR(slope(Tiling::repeat, 52.0 + 10.0), 0.1, 1e-6);
  EXPECT_NEAR(slope(Tiling::repeat, -156.0 + 10.0), 0.1, 1e-6);
  EXPECT_NEAR(slope(Tiling::repeat, 51.0), 0.01 * (0.0 - 250.0), 1e-5);  // to the next copy
  EXPECT_NEAR(slope(Tiling::mirror, 52.0 + 10.0), -0.1, 1e-6);
  EXPECT_NEAR(slope(Tiling::mirror, -10.0), -0.1, 1e-6);
}

TEST(NormalMap, KeepsTheMagnitudeOfTheForceWhateverTheSlope) {
  for (const char* const law : {"grey_level", "physical"}) {
    for (const double scale : {0.0, 1.0, 10.0, 100.0}) {
      const RendererInputs inputs =
          map_inputs(grating(), {{"law", std::string(law)}, {"height_scale", scale}});
      for (int place = 0; place < 50; ++place) {
        EXPECT_NEAR(glm::length(map_N(inputs, {1.03e-4 * place, 0.0, -0.002})),
                    kMap_N_per_m * 0.002, 1e-12);
      }
    }
  }
}

// The direction of `local_normal`, with the plate's F_n instead of that of the grating.
TEST(NormalMap, IsTheLocalNormalOfASinusoidInItsPhysicalLaw) {
  constexpr Grating kFine{.amplitude_m = 2e-4, .wavelength_m = 2e-3, .pitch_m = 1e-5};
  for (const double motion_scale : {1.0, 0.5}) {
    RendererInputs inputs = map_inputs(grating(kFine), {{"law", std::string("physical")}});
    inputs.patch.motion_scale = motion_scale;
    RendererInputs analytic = inputs;
    analytic.parameters = {{"amplitude_m", kFine.amplitude_m},
                           {"wavelength_m", kFine.wavelength_m},
                           {"force_direction", std::string("local_normal")}};
    const auto sinusoid = make_renderer(sinusoid_model(), analytic);
    for (int place = 0; place < 40; ++place) {
      const glm::dvec3 at_m{5.3e-5 * place, 0.0, -0.002};
      const RenderedTick grated = answer(*sinusoid, probe_at(at_m));
      const double of_plate = 0.002 / grated.penetration_m;
      EXPECT_LT(glm::length(map_N(inputs, at_m) - of_plate * grated.wrench.force_N), 1e-4) << place;
    }
  }
}

// From a trough to the next crest at one depth and back at another: k·(w₂ − w₁)·∫s/√(1 + s²)dx = k·(w₂ − w₁)·2·atan(a)/q,
// with s = a·cos(qx). The ways down and up are at slope 0 and cancel.
TEST(NormalMap, DoesTheWorkOfItsClosedFormOnALoop) {
  constexpr Grating kFine{.amplitude_m = 2e-4, .wavelength_m = 2e-3, .pitch_m = 1e-5};
  const double number_per_m = 2.0 * std::numbers::pi / kFine.wavelength_m;
  const double slope = kFine.amplitude_m * number_per_m;
  const RendererInputs inputs = map_inputs(grating(kFine), {{"law", std::string("physical")}});
  const auto renderer = make_renderer(normal_map_model(), inputs);
  constexpr int kParts = 4000;
  double work_J = 0.0;
  for (int part = 0; part < kParts; ++part) {
    const double x_m = (-0.25 + 0.5 * (part + 0.5) / kParts) * kFine.wavelength_m;
    const double step_m = 0.5 * kFine.wavelength_m / kParts;
    work_J += answer(*renderer, probe_at({x_m, 0.0, -5e-4})).wrench.force_N.x * step_m;
    work_J -= answer(*renderer, probe_at({x_m, 0.0, -2e-3})).wrench.force_N.x * step_m;
  }
  const double expected_J = kMap_N_per_m * 1.5e-3 * 2.0 * std::atan(slope) / number_per_m;
  EXPECT_GT(expected_J, 2e-4);
  EXPECT_NEAR(work_J, expected_J, 1e-4 * expected_J);
}

}  // namespace
}  // namespace asperity
