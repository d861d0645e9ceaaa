// The overlap of a tip with a relief in the cells of a contact, and the means of a relief over cells.

#include "renderers/elastic/pressed_tip.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/renderers/surfaces.h"

namespace asperity {
namespace {

constexpr double kRadiusOfTip_m = 0.003;
constexpr double kCell_m = kRadiusOfTip_m / PressedTip::kCellsInRadius;
const std::array<PressedTip::Place, 1> kOrigin{};

TEST(PressedTip, OverlapsAPlaneByItsProfileAndItsTilt) {
  PressedTip tip({.end = TipEnd::ball, .radius_m = kRadiusOfTip_m}, {.field = level(0.0F)});
  EXPECT_DOUBLE_EQ(tip.cell_m(), kCell_m);
  constexpr double kDepth_m = 0.001;
  const PressedTip::Overlap& overlap =
      tip.overlap({.height_m = -kDepth_m, .tilt = {0.02, -0.01}}, kOrigin);
  for (const std::size_t column : {std::size_t{12}, std::size_t{19}}) {
    constexpr std::size_t kRow = 14;
    const double x_m = kCell_m * from_centre(column);
    const double y_m = kCell_m * from_centre(kRow);
    const double expected_m =
        kDepth_m - 0.5 * (x_m * x_m + y_m * y_m) / kRadiusOfTip_m - 0.02 * x_m + 0.01 * y_m;
    EXPECT_NEAR(overlap.depth_m[kRow * kCellsAcross + column], expected_m, 1e-12);
  }
}

TEST(PressedTip, HasAFlatEndOfItsRadius) {
  PressedTip tip({.end = TipEnd::flat, .radius_m = kRadiusOfTip_m}, {.field = level(0.0F)});
  const PressedTip::Overlap& overlap = tip.overlap({.height_m = -0.001}, kOrigin);
  std::size_t inside = 0;
  for (const double depth_m : overlap.depth_m) inside += depth_m > 0.0 ? 1 : 0;
  EXPECT_NEAR(static_cast<double>(inside), std::numbers::pi * 225.0, 12.0);
  EXPECT_DOUBLE_EQ(overlap.deepest_m, 0.001);
}

TEST(PressedTip, ReadsTheReliefAtItsPlaceWithItsScales) {
  constexpr Grating kRelief{.amplitude_m = 1e-4, .wavelength_m = 0.004, .pitch_m = 0.0002};
  PressedTip tip({.end = TipEnd::flat, .radius_m = kRadiusOfTip_m},
                 {.field = grating(kRelief), .height_scale = 2.0, .motion_scale = 0.5});
  constexpr double kAt_m = 0.0003;
  const PressedTip::Overlap& overlap =
      tip.overlap({.height_m = -0.001}, std::array{PressedTip::Place{.x_m = kAt_m}});
  constexpr std::size_t kCell = 16 * kCellsAcross + 20;
  const double phase = 2.0 * std::numbers::pi * (kAt_m + 0.5 * kCell_m * from_centre(20)) / 0.004;
  EXPECT_NEAR(overlap.depth_m[kCell], 0.001 + 2e-4 * std::sin(phase), 2e-7);
  EXPECT_NEAR(overlap.slope_x[kCell], 0.5 * 2e-4 * 2.0 * std::numbers::pi / 0.004 * std::cos(phase),
              2e-3);
  EXPECT_NEAR(overlap.slope_y[kCell], 0.0, 1e-9);
}

// A grating along x that is seen along y, with a quarter of the weight, on a plane 0.1 mm above it.
TEST(PressedTip, BlendsTheReliefsOfItsPlacesInTheAxesOfTheWindow) {
  constexpr Grating kRelief{.amplitude_m = 1e-4, .wavelength_m = 0.004, .pitch_m = 0.0002};
  PressedTip tip({.end = TipEnd::flat, .radius_m = kRadiusOfTip_m}, {.field = grating(kRelief)});
  const PressedTip::Place along_x{.x_m = 0.0003, .weight = 0.75};
  // y of the window is −x of the texture, and its x is y of the texture.
  const PressedTip::Place along_y{.x_m = 0.0007, .turn = {{0.0, 1.0}, {-1.0, 0.0}}, .weight = 0.25};
  const PressedTip::Overlap& overlap =
      tip.overlap({.height_m = -0.001}, std::array{along_x, along_y});
  constexpr std::size_t kColumn = 20;
  constexpr std::size_t kRow = 12;
  constexpr std::size_t kCell = kRow * kCellsAcross + kColumn;
  const double wave_rad_per_m = 2.0 * std::numbers::pi / kRelief.wavelength_m;
  const double phase_x = wave_rad_per_m * (0.0003 + kCell_m * from_centre(kColumn));
  const double phase_y = wave_rad_per_m * (0.0007 - kCell_m * from_centre(kRow));
  EXPECT_NEAR(overlap.depth_m[kCell],
              0.001 + 1e-4 * (0.75 * std::sin(phase_x) + 0.25 * std::sin(phase_y)), 2e-7);
  EXPECT_NEAR(overlap.slope_x[kCell], 0.75 * 1e-4 * wave_rad_per_m * std::cos(phase_x), 1e-3);
  EXPECT_NEAR(overlap.slope_y[kCell], -0.25 * 1e-4 * wave_rad_per_m * std::cos(phase_y), 1e-3);
}

TEST(MeansOverSquares, KeepTheSincOfAWaveAndASeam) {
  constexpr Grating kRelief{.amplitude_m = 1e-4, .wavelength_m = 0.002, .pitch_m = 0.00002};
  const auto field = grating(kRelief);
  for (const double side_m : {0.0005, 0.00073}) {
    const auto means = means_over_squares(field, side_m, Tiling::repeat);
    const double u = std::numbers::pi * side_m / 0.002;
    EXPECT_NEAR(means->maximum_m(), 1e-4 * std::sin(u) / u, 1e-7);
    EXPECT_NEAR(means->minimum_m(), -1e-4 * std::sin(u) / u, 1e-7);
    const double seam_m = 0.5 * field->width_m();
    EXPECT_NEAR(means->sample(seam_m, 0.0, Tiling::repeat).height_m, 0.0, 1e-8);
  }
  EXPECT_EQ(means_over_squares(field, 0.00002, Tiling::repeat), field);
}

TEST(MeansOverSquares, ContinueTheBordersAsTheFieldDoes) {
  std::vector<float> steps_m(8 * 8, 0.0F);
  for (std::size_t row = 0; row < 8; ++row) steps_m[row * 8 + 7] = 1e-3F;
  const auto field =
      std::make_shared<const HeightField>(HeightField::Grid{8, 8, 1e-3}, std::move(steps_m));
  const auto first_m = [&](Tiling tiling) {
    return static_cast<double>(means_over_squares(field, 3e-3, tiling)->heights_m()[0]);
  };
  const auto last_m = [&](Tiling tiling) {
    return static_cast<double>(means_over_squares(field, 3e-3, tiling)->heights_m()[7]);
  };
  EXPECT_NEAR(first_m(Tiling::repeat), 1e-3 / 3.0, 1e-9);
  EXPECT_NEAR(first_m(Tiling::mirror), 0.0, 1e-9);
  EXPECT_NEAR(first_m(Tiling::bounded), 0.0, 1e-9);
  EXPECT_NEAR(last_m(Tiling::repeat), 1e-3 / 3.0, 1e-9);
  EXPECT_NEAR(last_m(Tiling::mirror), 2e-3 / 3.0, 1e-9);
  EXPECT_NEAR(last_m(Tiling::bounded), 2e-3 / 3.0, 1e-9);
}

}  // namespace
}  // namespace asperity
