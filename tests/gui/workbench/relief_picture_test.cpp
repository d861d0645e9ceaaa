// The projection, exaggeration, dents, holes and light of a drawn relief.

#include "app/gui/workbench/relief_picture.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "stimuli/heights/synthetic_surface.h"

namespace asperity {
namespace {

constexpr QSize kSize{400, 300};

HeightField steep_ridges() {
  // 0.1 mm from trough to crest over 2 mm: ten times that is a twelfth of the width, and more.
  return make_surface("sinusoid", {{"amplitude_m", 5e-5}, {"spacing_m", 0.002}},
                      {.width_m = 0.02, .pixels = 256, .seed = 1});
}

double mean_brightness(const QImage& picture) {
  double sum = 0.0;
  int count = 0;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      if (qAlpha(picture.pixel(x, y)) < 255) continue;
      sum += qGray(picture.pixel(x, y));
      ++count;
    }
  }
  return count > 0 ? sum / count : 0.0;
}

TEST(ReliefProjection, FindsThePointThatItDrew) {
  for (const double turn_rad : {-2.0, -0.4, 0.0, 1.3}) {
    for (const double tilt_rad : {0.4, 1.0, std::numbers::pi / 2.0}) {
      const ReliefProjection projection({.turn_rad = turn_rad, .tilt_rad = tilt_rad}, 0.1, 0.06,
                                        kSize);
      const auto found = projection.on_surface(projection.on_screen({0.031, -0.017, 0.0}));
      ASSERT_TRUE(found.has_value());
      EXPECT_NEAR(found->x, 0.031, 1e-9);
      EXPECT_NEAR(found->y, -0.017, 1e-9);
    }
  }
}

TEST(ReliefProjection, FindsNothingBesideTheRelief) {
  const ReliefProjection projection({}, 0.1, 0.06, kSize);
  EXPECT_FALSE(projection.on_surface(projection.on_screen({0.051, 0.0, 0.0})).has_value());
  EXPECT_FALSE(projection.on_surface(projection.on_screen({0.0, 0.031, 0.0})).has_value());
}

TEST(ReliefProjection, KeepsTheReliefInThePictureHoweverItIsTurned) {
  const HeightField field = steep_ridges();
  const ReliefMesh mesh = relief_mesh(field, 64);
  for (double turn_rad = 0.0; turn_rad < 6.3; turn_rad += 0.3) {
    const QImage picture = draw_relief(mesh, {.turn_rad = turn_rad, .tilt_rad = 0.6}, kSize);
    for (int x = 0; x < picture.width(); ++x) {
      ASSERT_EQ(qAlpha(picture.pixel(x, 0)), 0);
      ASSERT_EQ(qAlpha(picture.pixel(x, picture.height() - 1)), 0);
    }
  }
}

TEST(ReliefMesh, SaysHowManyTimesTooHighItIs) {
  const HeightField field = steep_ridges();
  const ReliefMesh mesh = relief_mesh(field, 256);
  EXPECT_GT(mesh.exaggeration, 1.0);
  EXPECT_NEAR(mesh.highest_m - mesh.lowest_m,
              mesh.exaggeration * (field.maximum_m() - field.minimum_m()), 1e-6);
  EXPECT_LE(mesh.highest_m - mesh.lowest_m, mesh.width_m / 12.0);
}

// 0.2 mm deep within ±2 mm, drawn as much deeper as the ridges are higher.
TEST(ReliefMesh, IsPressedInByADent) {
  const ReliefMesh mesh = relief_mesh(steep_ridges(), 64);
  SurfaceDent dent{.centre_m = {0.003, -0.002}, .cell_m = 0.004 / 31.0};
  dent.depth_m.fill(2e-4);
  const ReliefMesh pressed = pressed_in(mesh, dent);
  const auto lowered_m = [&](double x_m, double y_m) {
    const auto column = static_cast<std::size_t>((0.5 + x_m / mesh.width_m) * 64.0);
    const auto row = static_cast<std::size_t>((0.5 - y_m / mesh.length_m) * 64.0);
    const std::size_t at = row * mesh.columns + column;
    return static_cast<double>(mesh.heights_m[at] - pressed.heights_m[at]);
  };
  EXPECT_NEAR(lowered_m(0.003, -0.002), mesh.exaggeration * 2e-4, 1e-7);
  EXPECT_NEAR(lowered_m(0.0045, -0.0035), mesh.exaggeration * 2e-4, 1e-7);
  EXPECT_NEAR(lowered_m(-0.005, -0.002), mesh.exaggeration * 2e-4 / 64.0,
              0.1 * mesh.exaggeration * 2e-4 / 64.0);
  EXPECT_EQ(pressed.lowest_m, mesh.lowest_m);
}

TEST(DrawRelief, LeavesNoHolesInTheSurface) {
  const ReliefMesh mesh = relief_mesh(steep_ridges(), 192);
  const ReliefLook look{.turn_rad = 0.7, .tilt_rad = 1.1};
  const QImage picture = draw_relief(mesh, look, kSize);
  const ReliefProjection projection(look, mesh.width_m, mesh.length_m, kSize);
  for (double x_m = -0.009; x_m < 0.009; x_m += 0.0002) {
    for (double y_m = -0.009; y_m < 0.009; y_m += 0.0002) {
      const QPoint at = projection.on_screen({x_m, y_m, 0.0}).toPoint();
      ASSERT_EQ(qAlpha(picture.pixel(at)), 255) << x_m << ' ' << y_m;
    }
  }
}

TEST(DrawRelief, GetsDarkerWhenTheLightSinks) {
  const ReliefMesh mesh = relief_mesh(steep_ridges(), 128);
  const double high = mean_brightness(draw_relief(mesh, {.light_elevation_rad = 1.4}, kSize));
  const double low = mean_brightness(draw_relief(mesh, {.light_elevation_rad = 0.2}, kSize));
  EXPECT_GT(high, 1.3 * low);
}

}  // namespace
}  // namespace asperity
