// Two textured bodies as one relief, against laws that can be written down.

#include "renderers/offline/composed_relief.h"

#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "stimuli/meshes/solid_body.h"
#include "tests/renderers/surfaces.h"

namespace asperity {
namespace {

constexpr double kPitch_m = 1e-4;
constexpr double kWave_m = 2e-3;
constexpr double kPerMetre = 2.0 * std::numbers::pi / kWave_m;

struct Cosine {
  double amplitude_m = 0.0;
  bool is_along_y = false;
  double raised_m = 0.0;
};

/// h = A·cos κx over whole waves, or along y, and some height more.
HeightField cosine_field(const Cosine& wave) {
  constexpr std::size_t kSamples = 200;
  std::vector<float> heights_m(kSamples * kSamples);
  for (std::size_t row = 0; row < kSamples; ++row) {
    for (std::size_t column = 0; column < kSamples; ++column) {
      const double at_m =
          (static_cast<double>(wave.is_along_y ? row : column) - 0.5 * (kSamples - 1.0)) * kPitch_m;
      heights_m[row * kSamples + column] =
          static_cast<float>(wave.raised_m + wave.amplitude_m * std::cos(kPerMetre * at_m));
    }
  }
  return {{kSamples, kSamples, kPitch_m}, std::move(heights_m)};
}

TexturedMesh cosine_plate(double amplitude_m, bool is_along_y = false) {
  const HeightField field = cosine_field({.amplitude_m = amplitude_m, .is_along_y = is_along_y});
  return placed(body_mesh(PlateShape{{0.026, 0.02, 0.006}}, &field), BodyRole::surface);
}
/// Its relief stands out far enough for its rim, which has none, to touch nothing.
TexturedMesh cosine_block(double amplitude_m) {
  const HeightField field =
      cosine_field({.amplitude_m = amplitude_m, .raised_m = 2.0 * amplitude_m});
  return placed(body_mesh(BoxShape{{0.012, 0.012, 0.006}}, &field), BodyRole::tool);
}
TexturedMesh textured_ball(double diameter_m) {
  return placed(body_mesh(SphereShape{diameter_m}, nullptr), BodyRole::tool);
}

/// Holds the middle row to a law of the place along the stroke, heights counted from its mean.
void expect_along(const HeightField& relief, const std::function<double(double x_m)>& law_m,
                  double tolerance_m) {
  const auto [rows, columns, pitch_m] = relief.grid();
  std::vector<double> found_m(columns);
  std::vector<double> wanted_m(columns);
  double offset_m = 0.0;
  for (std::size_t column = 0; column < columns; ++column) {
    const double x_m =
        (static_cast<double>(column) - 0.5 * (static_cast<double>(columns) - 1.0)) * pitch_m;
    found_m[column] = static_cast<double>(relief.heights_m()[rows / 2 * columns + column]);
    wanted_m[column] = law_m(x_m);
    offset_m += (found_m[column] - wanted_m[column]) / static_cast<double>(columns);
  }
  for (std::size_t column = 0; column < columns; ++column) {
    ASSERT_NEAR(found_m[column] - offset_m, wanted_m[column], tolerance_m) << column;
  }
}

constexpr TipStroke kStroke{.length_m = 0.008, .cell_m = 5e-5};

TEST(ComposedRelief, IsTheSurfaceItselfUnderATipThatFitsEverywhere) {
  const TexturedMesh plate = cosine_plate(2e-5);
  const TexturedMesh tip = textured_ball(2e-4);
  const HeightField relief = composed_relief({.mesh = tip}, {.mesh = plate}, kStroke);
  EXPECT_NEAR(relief.width_m(), kStroke.length_m, 2.0 * kStroke.cell_m);
  expect_along(
      relief, [](double x_m) { return 2e-5 * std::cos(kPerMetre * x_m); }, 1e-6);
  const HeightField deeper = composed_relief({.mesh = tip}, {.mesh = plate, .gain = 2.0}, kStroke);
  expect_along(
      deeper, [](double x_m) { return 4e-5 * std::cos(kPerMetre * x_m); }, 2e-6);
}

TEST(ComposedRelief, OfTwoGratingsOfOneLengthIsTheSumOfTheirVectors) {
  constexpr double kOfPlate_m = 2e-4;
  constexpr double kOfBlock_m = 5e-5;
  const TexturedMesh plate = cosine_plate(kOfPlate_m);
  const TexturedMesh block = cosine_block(kOfBlock_m);
  const auto law_m = [](double plate_m, double block_m) {
    return [=](double x_m) {
      return std::sqrt(plate_m * plate_m + block_m * block_m +
                       2.0 * plate_m * block_m * std::cos(kPerMetre * x_m));
    };
  };
  expect_along(composed_relief({.mesh = block}, {.mesh = plate}, kStroke),
               law_m(kOfPlate_m, kOfBlock_m), 2e-6);
  expect_along(composed_relief({.mesh = block, .gain = 3.0}, {.mesh = plate}, kStroke),
               law_m(kOfPlate_m, 3.0 * kOfBlock_m), 4e-6);
  // Either alone is no texture for what lies flat on it.
  expect_along(
      composed_relief({.mesh = block, .gain = 0.0}, {.mesh = plate}, kStroke),
      [](double) { return 0.0; }, 2e-6);
  expect_along(
      composed_relief({.mesh = block}, {.mesh = plate, .gain = 0.0}, kStroke),
      [](double) { return 0.0; }, 2e-6);
}

// From crest to crest a ball of radius R that is too large for the troughs sinks by R − √(R² − (λ/2)²), but for what
// the crests are round.
TEST(ComposedRelief, LeavesTroughsOutThatABallDoesNotFit) {
  constexpr double kAmplitude_m = 5e-4;
  constexpr double kRadius_m = 5e-3;
  const TexturedMesh plate = cosine_plate(kAmplitude_m);
  const TexturedMesh tool = textured_ball(2.0 * kRadius_m);
  const HeightField relief = composed_relief({.mesh = tool}, {.mesh = plate}, kStroke);
  const double sunk_m = kRadius_m - std::sqrt(kRadius_m * kRadius_m - 0.25 * kWave_m * kWave_m);
  EXPECT_NEAR(relief.maximum_m() - relief.minimum_m(), sunk_m, 0.2 * sunk_m);
  EXPECT_LT(relief.maximum_m() - relief.minimum_m(), 0.15 * kAmplitude_m * 2.0);
}

TEST(ComposedRelief, IsThatOfTheStrokesDirection) {
  const TexturedMesh plate = cosine_plate(2e-5, true);
  const TexturedMesh tip = textured_ball(2e-4);
  TipStroke stroke = kStroke;
  expect_along(
      composed_relief({.mesh = tip}, {.mesh = plate}, stroke), [](double) { return 0.0; }, 1e-6);
  stroke.direction_rad = 0.5 * std::numbers::pi;
  expect_along(
      composed_relief({.mesh = tip}, {.mesh = plate}, stroke),
      [](double x_m) { return 2e-5 * std::cos(kPerMetre * x_m); }, 1e-6);
}

TEST(ComposedRelief, EndsWithTheSurface) {
  const TexturedMesh plate = cosine_plate(2e-5);
  const TexturedMesh tip = textured_ball(2e-3);
  const HeightField relief =
      composed_relief({.mesh = tip}, {.mesh = plate}, {.length_m = 0.05, .cell_m = 1e-4});
  // 26 mm, and beyond both ends as far as the ball still lies on an edge.
  EXPECT_GT(relief.width_m(), 0.0259);
  EXPECT_LT(relief.width_m(), 0.0282);
}

TEST(ComposedRelief, HasThePitchThatIsAskedForInWholeCells) {
  const TexturedMesh plate = cosine_plate(2e-5);
  const TexturedMesh tip = textured_ball(2e-4);
  TipStroke stroke = kStroke;
  stroke.pitch_m = 1.6e-4;
  const HeightField relief = composed_relief({.mesh = tip}, {.mesh = plate}, stroke);
  EXPECT_NEAR(relief.grid().pitch_m, 1.5e-4, 1e-12);
  expect_along(
      relief, [](double x_m) { return 2e-5 * std::cos(kPerMetre * x_m); }, 1e-6);
}

TEST(ComposedRelief, RefusesWhatCannotBe) {
  const TexturedMesh plate = cosine_plate(2e-5);
  const TexturedMesh tip = textured_ball(2e-4);
  TexturedMesh elsewhere = plate;
  for (glm::dvec3& vertex_m : elsewhere.vertices_m) vertex_m.x += 0.1;
  EXPECT_THROW(composed_relief({.mesh = tip}, {.mesh = elsewhere}, kStroke), std::invalid_argument);
  EXPECT_THROW(composed_relief({.mesh = tip}, {.mesh = plate}, {.length_m = 0.0}),
               std::invalid_argument);
  EXPECT_THROW(composed_relief({.mesh = tip, .gain = -1.0}, {.mesh = plate}, kStroke),
               std::invalid_argument);
}

}  // namespace
}  // namespace asperity
