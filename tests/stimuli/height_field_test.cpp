// Heights between samples: the interpolant's promises, its gradient, and what lies beyond the
// border.

#include "stimuli/heights/height_field.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace asperity {
namespace {

constexpr HeightField::Grid kGrid{.rows = 5, .columns = 7, .pitch_m = 2e-4};

double x_of(const HeightField::Grid& grid, std::size_t column) {
  return (static_cast<double>(column) - 0.5 * static_cast<double>(grid.columns - 1)) * grid.pitch_m;
}

double y_of(const HeightField::Grid& grid, std::size_t row) {
  return (0.5 * static_cast<double>(grid.rows - 1) - static_cast<double>(row)) * grid.pitch_m;
}

// Heights without any symmetry that an exchanged index could hide behind.
HeightField rugged() {
  std::vector<float> heights_m;
  for (std::size_t i = 0; i < kGrid.rows * kGrid.columns; ++i) {
    heights_m.push_back(static_cast<float>(1e-4 * std::sin(1.7 * static_cast<double>(i * i + 3))));
  }
  return {kGrid, heights_m};
}

// h = 1e-5 + 0.3 x − 0.2 y
HeightField plane(const HeightField::Grid& grid) {
  std::vector<float> heights_m;
  for (std::size_t i = 0; i < grid.rows; ++i) {
    for (std::size_t j = 0; j < grid.columns; ++j) {
      heights_m.push_back(static_cast<float>(1e-5 + 0.3 * x_of(grid, j) - 0.2 * y_of(grid, i)));
    }
  }
  return {grid, heights_m};
}

const std::vector<Tiling> kTilings{Tiling::bounded, Tiling::repeat, Tiling::mirror};

TEST(HeightField, PassesThroughEverySample) {
  const HeightField field = rugged();
  for (const Tiling tiling : kTilings) {
    for (std::size_t i = 0; i < kGrid.rows; ++i) {
      for (std::size_t j = 0; j < kGrid.columns; ++j) {
        EXPECT_NEAR(field.sample(x_of(kGrid, j), y_of(kGrid, i), tiling).height_m,
                    static_cast<double>(field.heights_m()[i * kGrid.columns + j]), 1e-16);
      }
    }
  }
}

TEST(HeightField, ReproducesAPlaneAndItsSlopesExactly) {
  const HeightField field = plane({.rows = 9, .columns = 9, .pitch_m = 1e-3});
  const HeightSample sample = field.sample(1.234e-3, -0.777e-3, Tiling::bounded);
  EXPECT_NEAR(sample.height_m, 1e-5 + 0.3 * 1.234e-3 + 0.2 * 0.777e-3, 1e-10);  // float storage
  EXPECT_NEAR(sample.slope_x, 0.3, 1e-6);
  EXPECT_NEAR(sample.slope_y, -0.2, 1e-6);
}

TEST(HeightField, HasTheTopRowFirst) {
  const HeightField field({.rows = 2, .columns = 2, .pitch_m = 1.0}, {1.0F, 1.0F, 0.0F, 0.0F});
  EXPECT_DOUBLE_EQ(field.sample(0.0, 0.5, Tiling::bounded).height_m, 1.0);
  EXPECT_DOUBLE_EQ(field.sample(0.0, -0.5, Tiling::bounded).height_m, 0.0);
  EXPECT_GT(field.sample(0.0, 0.0, Tiling::bounded).slope_y, 0.0);
}

// Keys 1981, a = −½, half way between two samples: (−1, 9, 9, −1)/16.
TEST(HeightField, WeighsFourSamplesHalfWayAsKeysDoes) {
  std::vector<float> heights_m;
  for (int i = 0; i < 4; ++i) {
    for (const float height_m : {1.0F, 2.0F, 4.0F, 8.0F}) heights_m.push_back(height_m);
  }
  const HeightField field({.rows = 4, .columns = 4, .pitch_m = 1.0}, heights_m);
  EXPECT_DOUBLE_EQ(field.sample(0.0, 0.5, Tiling::bounded).height_m,
                   (-1.0 + 9.0 * 2.0 + 9.0 * 4.0 - 8.0) / 16.0);
}

TEST(HeightField, ReturnsTheGradientOfWhatItInterpolates) {
  const HeightField field = rugged();
  constexpr double kStep_m = 1e-8;
  for (const Tiling tiling : kTilings) {
    for (int k = 0; k < 400; ++k) {
      // Over three periods in both directions, and never twice the same fraction.
      const double x_m = 4.2e-3 * std::sin(0.37 * k);
      const double y_m = 3.0e-3 * std::sin(0.53 * k + 1.0);
      const auto height_m = [&](double dx_m, double dy_m) {
        return field.sample(x_m + dx_m, y_m + dy_m, tiling).height_m;
      };
      const HeightSample sample = field.sample(x_m, y_m, tiling);
      EXPECT_NEAR(sample.slope_x, (height_m(kStep_m, 0) - height_m(-kStep_m, 0)) / (2 * kStep_m),
                  1e-3);
      EXPECT_NEAR(sample.slope_y, (height_m(0, kStep_m) - height_m(0, -kStep_m)) / (2 * kStep_m),
                  1e-3);
    }
  }
}

TEST(HeightField, HasNoStepAndNoKinkAcrossCellsAndBorders) {
  const HeightField field = rugged();
  constexpr double kStep_m = 1e-12;
  for (const Tiling tiling : kTilings) {
    for (int cell = -30; cell <= 30; ++cell) {  // in half samples: nodes, and the mirror's axes
      const double at_m = 0.5 * cell * kGrid.pitch_m;
      const HeightSample left = field.sample(at_m - kStep_m, 0.3e-4, tiling);
      const HeightSample right = field.sample(at_m + kStep_m, 0.3e-4, tiling);
      EXPECT_NEAR(left.height_m, right.height_m, 1e-11);
      EXPECT_NEAR(left.slope_x, right.slope_x, 1e-6);
      EXPECT_NEAR(left.slope_y, right.slope_y, 1e-6);
      const HeightSample below = field.sample(0.3e-4, at_m - kStep_m, tiling);
      const HeightSample above = field.sample(0.3e-4, at_m + kStep_m, tiling);
      EXPECT_NEAR(below.height_m, above.height_m, 1e-11);
      EXPECT_NEAR(below.slope_x, above.slope_x, 1e-6);
      EXPECT_NEAR(below.slope_y, above.slope_y, 1e-6);
    }
  }
}

TEST(HeightField, RepeatsWithThePeriodOfItsSize) {
  const HeightField field = rugged();
  const HeightSample here = field.sample(1.3e-4, -0.9e-4, Tiling::repeat);
  const HeightSample there = field.sample(1.3e-4 - 3.0 * field.width_m(),
                                          -0.9e-4 + 2.0 * field.length_m(), Tiling::repeat);
  EXPECT_NEAR(here.height_m, there.height_m, 1e-14);
  EXPECT_NEAR(here.slope_x, there.slope_x, 1e-9);
}

TEST(HeightField, MirrorsAtItsOuterLines) {
  const HeightField field = rugged();
  for (const double beyond_m : {0.3e-4, 1.1e-4, 5.0e-4}) {
    const double edge_m = 0.5 * field.width_m();
    const HeightSample inside = field.sample(edge_m - beyond_m, 0.7e-4, Tiling::mirror);
    const HeightSample outside = field.sample(edge_m + beyond_m, 0.7e-4, Tiling::mirror);
    EXPECT_NEAR(inside.height_m, outside.height_m, 1e-14);
    EXPECT_NEAR(inside.slope_x, -outside.slope_x, 1e-9);
    EXPECT_NEAR(inside.slope_y, outside.slope_y, 1e-9);
    const double top_m = 0.5 * field.length_m();
    EXPECT_NEAR(field.sample(0.7e-4, top_m - beyond_m, Tiling::mirror).height_m,
                field.sample(0.7e-4, top_m + beyond_m, Tiling::mirror).height_m, 1e-14);
  }
}

TEST(HeightField, KeepsTheHeightOfItsNearestEdgeWhenBounded) {
  const HeightField field = rugged();
  const HeightSample far = field.sample(1.0, 0.0, Tiling::bounded);
  EXPECT_NEAR(far.height_m, field.sample(x_of(kGrid, 6), 0.0, Tiling::bounded).height_m, 1e-16);
  EXPECT_EQ(far.slope_x, 0.0);
}

TEST(HeightField, AnswersAtAnyFinitePosition) {
  const HeightField field = rugged();
  const double huge_m = std::numeric_limits<double>::max();
  for (const Tiling tiling : kTilings) {
    for (const double x_m : {-huge_m, -1e30, 1e18, huge_m}) {
      const HeightSample sample = field.sample(x_m, x_m, tiling);
      EXPECT_TRUE(std::isfinite(sample.height_m) && std::isfinite(sample.slope_x));
      EXPECT_LE(std::abs(sample.height_m), 2e-4);
    }
  }
}

// 0, 1, 2, 3 about the mean 1.5: √((2·1.5² + 2·0.5²)/4) = √1.25.
TEST(HeightField, StatesItsExtremesMeanAndRms) {
  const HeightField field({.rows = 2, .columns = 2, .pitch_m = 0.5}, {0.0F, 1.0F, 2.0F, 3.0F});
  EXPECT_DOUBLE_EQ(field.minimum_m(), 0.0);
  EXPECT_DOUBLE_EQ(field.maximum_m(), 3.0);
  EXPECT_DOUBLE_EQ(field.mean_m(), 1.5);
  EXPECT_DOUBLE_EQ(field.rms_m(), std::sqrt(1.25));
  EXPECT_DOUBLE_EQ(field.width_m(), 1.0);
}

TEST(HeightField, RefusesWhatIsNotAGridOfHeights) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(HeightField({.rows = 2, .columns = 2, .pitch_m = 0.0}, std::vector<float>(4)),
               std::invalid_argument);
  EXPECT_THROW(HeightField({.rows = 2, .columns = 2, .pitch_m = HUGE_VAL}, std::vector<float>(4)),
               std::invalid_argument);
  EXPECT_THROW(HeightField({.rows = 1, .columns = 4, .pitch_m = 1.0}, std::vector<float>(4)),
               std::invalid_argument);
  EXPECT_THROW(HeightField({.rows = 2, .columns = 2, .pitch_m = 1.0}, std::vector<float>(5)),
               std::invalid_argument);
  EXPECT_THROW(HeightField({.rows = 2, .columns = 2, .pitch_m = 1.0}, {0.0F, 0.0F, nan, 0.0F}),
               std::invalid_argument);
}

}  // namespace
}  // namespace asperity
