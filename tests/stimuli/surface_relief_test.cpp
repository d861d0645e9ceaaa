// From a measured surface to a height field: the plane, the missing points, the distances.

#include "stimuli/measured/surface_relief.h"

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include <gmock/gmock.h>

#include "tests/support/refusal.h"

namespace asperity::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr double kNotMeasured = std::numeric_limits<double>::quiet_NaN();

/// h(x, y) in metres, x to the right and y upwards from the upper left point.
MeasuredSurface surface_of(std::size_t columns, std::size_t rows, double pitch_x_m,
                           double pitch_y_m, const std::function<double(double, double)>& h) {
  MeasuredSurface surface{
      .rows = rows, .columns = columns, .pitch_x_m = pitch_x_m, .pitch_y_m = pitch_y_m};
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < columns; ++j) {
      surface.heights_m.push_back(
          h(static_cast<double>(j) * pitch_x_m, -static_cast<double>(i) * pitch_y_m));
    }
  }
  return surface;
}

void remove_points(MeasuredSurface& surface, std::size_t first_column, std::size_t first_row,
                   std::size_t columns, std::size_t rows) {
  for (std::size_t i = first_row; i < first_row + rows; ++i) {
    for (std::size_t j = first_column; j < first_column + columns; ++j) {
      surface.heights_m[i * surface.columns + j] = kNotMeasured;
    }
  }
}

TEST(SurfaceRelief, OfAPlaneIsFlatAlsoWhereItWasNotMeasured) {
  MeasuredSurface plane =
      surface_of(40, 30, 1e-5, 1e-5, [](double x, double y) { return 0.3 + 0.02 * x - 0.05 * y; });
  remove_points(plane, 0, 0, 11, 7);
  remove_points(plane, 20, 15, 12, 9);
  const SurfaceRelief relief = surface_relief(plane, SurfaceForm::plane, "scan");
  EXPECT_NEAR(relief.slope_x, 0.02, 1e-12);
  EXPECT_NEAR(relief.slope_y, -0.05, 1e-12);
  EXPECT_LT(relief.field.maximum_m() - relief.field.minimum_m(), 1e-14);
  EXPECT_EQ(relief.points, 1200U);
  EXPECT_EQ(relief.missing, 11U * 7U + 12U * 9U);
  EXPECT_FALSE(relief.is_resampled);
  EXPECT_EQ(relief.field.grid().pitch_m, 1e-5);
}

TEST(SurfaceRelief, KeepsTheTiltWhenOnlyTheMeanIsSubtracted) {
  const MeasuredSurface plane =
      surface_of(40, 30, 1e-5, 1e-5, [](double x, double) { return 0.3 + 0.02 * x; });
  const SurfaceRelief relief = surface_relief(plane, SurfaceForm::mean, "scan");
  EXPECT_EQ(relief.slope_x, 0.0);
  EXPECT_NEAR(relief.field.maximum_m(), 0.02 * 39e-5 / 2, 1e-12);
  EXPECT_NEAR(relief.field.mean_m(), 0.0, 1e-12);
}

// x² − y² also has the mean of its four neighbours at every point of the grid, so that it is the solution within a hole.
TEST(SurfaceRelief, FillsAHoleWithTheSolutionOfLaplacesEquation) {
  const auto saddle = [](double x, double y) {
    return 1e-2 * (x - 4e-4) * (x - 4e-4) / 1e-3 - 1e-2 * (y + 3e-4) * (y + 3e-4) / 1e-3;
  };
  const MeasuredSurface whole = surface_of(80, 60, 1e-5, 1e-5, saddle);
  MeasuredSurface with_hole = whole;
  remove_points(with_hole, 13, 11, 40, 35);
  const HeightField expected = surface_relief(whole, SurfaceForm::mean, "scan").field;
  const HeightField found = surface_relief(with_hole, SurfaceForm::mean, "scan").field;
  // The mean is that of all points, filled or measured.
  for (std::size_t i = 0; i < expected.heights_m().size(); ++i) {
    EXPECT_NEAR(found.heights_m()[i], expected.heights_m()[i], 1e-4 * expected.rms_m()) << i;
  }
}

TEST(SurfaceRelief, LeavesMeasuredHeightsAsTheyAre) {
  const auto waves = [](double x, double y) {
    return 1e-6 * std::sin(x / 3e-5) * std::cos(y / 5e-5);
  };
  const MeasuredSurface whole = surface_of(50, 50, 1e-5, 1e-5, waves);
  MeasuredSurface with_holes = whole;
  for (std::size_t i = 3; i < whole.heights_m.size(); i += 7)
    with_holes.heights_m[i] = kNotMeasured;
  const SurfaceRelief found = surface_relief(with_holes, SurfaceForm::mean, "scan");
  const double shift_m = static_cast<double>(found.field.heights_m()[0]) - whole.heights_m[0];
  for (std::size_t i = 0; i < whole.heights_m.size(); ++i) {
    if (std::isnan(with_holes.heights_m[i])) continue;
    EXPECT_NEAR(static_cast<double>(found.field.heights_m()[i]) - shift_m, whole.heights_m[i],
                1e-12)
        << i;
  }
}

TEST(SurfaceRelief, HasSquareCellsWhenTheDistancesDiffer) {
  constexpr double kWave_m = 64e-5;
  const auto ridges = [](double, double y) {
    return 1e-6 * std::sin(2 * std::numbers::pi * y / kWave_m);
  };
  const MeasuredSurface surface = surface_of(65, 33, 1e-5, 2e-5, ridges);
  const SurfaceRelief relief = surface_relief(surface, SurfaceForm::mean, "scan");
  EXPECT_TRUE(relief.is_resampled);
  EXPECT_EQ(relief.field.grid().columns, 65U);
  ASSERT_EQ(relief.field.grid().rows, 65U);
  EXPECT_EQ(relief.field.grid().pitch_m, 1e-5);
  for (std::size_t i = 4; i < 61; ++i) {
    // The mean of the samples of whole waves is 0. Bicubic convolution is exact to the third order.
    EXPECT_NEAR(relief.field.heights_m()[i * 65 + 30], ridges(0, -static_cast<double>(i) * 1e-5),
                2e-9)
        << i;
  }
}

TEST(SurfaceRelief, RefusesTooFewPoints) {
  MeasuredSurface surface = surface_of(10, 10, 1e-5, 1e-5, [](double x, double) { return x; });
  remove_points(surface, 0, 0, 10, 5);
  EXPECT_NO_THROW(surface_relief(surface, SurfaceForm::plane, "scan"));
  surface.heights_m[50] = kNotMeasured;
  EXPECT_THAT(refusal_of<std::invalid_argument>(
                  [&] { surface_relief(surface, SurfaceForm::plane, "scan"); }),
              StartsWith("scan: only 49 of 100 points are measured; at least half"));
  MeasuredSurface line = surface_of(2, 2, 1e-5, 1e-5, [](double x, double) { return x; });
  remove_points(line, 0, 0, 2, 1);
  EXPECT_THAT(
      refusal_of<std::invalid_argument>([&] { surface_relief(line, SurfaceForm::plane, "scan"); }),
      HasSubstr("determine no plane"));
  MeasuredSurface flat = surface_of(100, 100, 1e-9, 1e-3, [](double, double) { return 0.0; });
  EXPECT_THAT(
      refusal_of<std::invalid_argument>([&] { surface_relief(flat, SurfaceForm::plane, "scan"); }),
      HasSubstr("resampled at the smaller of its two distances, the surface has 100 by"));
}

}  // namespace
}  // namespace asperity::test
