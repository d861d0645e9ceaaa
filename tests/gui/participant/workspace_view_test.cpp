// What a participant sees of the workspace, and what the picture must not tell.

#include "app/gui/participant/workspace_view.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>
#include <vector>

#include <QtCore/QElapsedTimer>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <gtest/gtest.h>

#include "app/gui/look/theme.h"
#include "stimuli/meshes/solid_body.h"
#include "tests/gui/support/screenshot.h"
#include "tests/gui/support/widgets.h"

namespace asperity {
namespace {

/// Waves 4 mm long in x and 7 mm in y, with an amplitude of 40 µm unless told otherwise.
std::shared_ptr<const HeightField> waves(double amplitude_m = 40e-6, double length_m = 0.004) {
  const HeightField::Grid grid{.rows = 500, .columns = 500, .pitch_m = 0.0002};
  std::vector<float> heights_m(grid.rows * grid.columns);
  for (std::size_t i = 0; i < heights_m.size(); ++i) {
    const double x_m = static_cast<double>(i % grid.columns) * grid.pitch_m;
    const double y_m = static_cast<double>(i / grid.columns) * grid.pitch_m;
    heights_m[i] = static_cast<float>(
        amplitude_m * (std::sin(2.0 * std::numbers::pi * x_m / length_m) +
                       0.5 * std::sin(2.0 * std::numbers::pi * (y_m / 0.007 + 3.0 * x_m))));
  }
  return std::make_shared<const HeightField>(grid, std::move(heights_m));
}

QImage seen(const SurfacePatch& patch, std::shared_ptr<const HeightField> relief,
            SurfaceLook look) {
  WorkspaceView view{};
  view.resize(480, 270);
  view.set_object(patch, std::move(relief), look);
  EXPECT_TRUE(eventually([&view] { return view.is_drawn(); }));
  return view.grab().toImage();
}

/// Pixels that differ between two pictures, and where.
struct Difference {
  int pixels = 0;
  double mean_column = 0.0;
};
Difference difference(const QImage& one, const QImage& other) {
  Difference found{};
  for (int row = 0; row < one.height(); ++row) {
    for (int column = 0; column < one.width(); ++column) {
      if (one.pixel(column, row) == other.pixel(column, row)) continue;
      ++found.pixels;
      found.mean_column += column;
    }
  }
  if (found.pixels > 0) found.mean_column /= found.pixels;
  return found;
}

TEST(WorkspaceCamera, FitsTheObjectIntoThePictureAndFindsItsPointsAgain) {
  SurfacePatch patch{};
  patch.centre_m = {0.02, -0.01, 0.05};
  patch.extent_m = {0.12, 0.08};
  const WorkspaceCamera camera(patch, {1280, 720});
  for (const double x_m : {-0.06, 0.0, 0.06}) {
    for (const double y_m : {-0.04, 0.0, 0.04}) {
      const glm::dvec3 place{x_m, y_m, 0.0};
      const QPointF pixel = camera.project(patch.centre_m + place);
      EXPECT_TRUE(QRectF(0, 0, 1280, 720).contains(pixel));
      const glm::dvec3 again = camera.point_at(pixel, 0.0);
      EXPECT_NEAR(again.x, x_m, 1e-9);
      EXPECT_NEAR(again.y, y_m, 1e-9);
    }
  }
  // Right is right, away is up, near is large.
  const auto at = [&](double x_m, double y_m, double z_m) {
    return camera.project(patch.centre_m + glm::dvec3{x_m, y_m, z_m});
  };
  EXPECT_GT(at(0.01, 0.0, 0.0).x(), at(0.0, 0.0, 0.0).x());
  EXPECT_NEAR(at(0.0, 0.02, 0.0).x(), 640.0, 1e-3);
  EXPECT_LT(at(0.0, 0.02, 0.0).y(), at(0.0, 0.0, 0.0).y());
  EXPECT_LT(at(0.0, 0.0, 0.02).y(), at(0.0, 0.0, 0.0).y());
  EXPECT_GT(at(0.06, -0.04, 0.0).x(), at(0.06, 0.04, 0.0).x());
}

TEST(WorkspaceView, ShowsTheReliefOnlyWhereItIsToBeSeen) {
  const SurfacePatch patch{};
  const QImage relief = seen(patch, waves(), SurfaceLook::relief);
  const QImage plain = seen(patch, waves(), SurfaceLook::plain);
  const QImage pattern = seen(patch, waves(), SurfaceLook::pattern);
  EXPECT_GT(difference(relief, plain).pixels, 20000);
  EXPECT_GT(difference(pattern, plain).pixels, 100);
  // A texture that is not to be seen leaves no trace in the picture.
  EXPECT_EQ(difference(seen(patch, waves(40e-6, 0.011), SurfaceLook::plain), plain).pixels, 0);
  EXPECT_EQ(difference(seen(patch, waves(40e-6, 0.011), SurfaceLook::pattern), pattern).pixels, 0);
  EXPECT_GT(difference(seen(patch, waves(40e-6, 0.011), SurfaceLook::relief), relief).pixels,
            20000);
}

// How high a relief is would be told by its contrast; only its shape is.
TEST(WorkspaceView, ReliefsOfOneShapeLookAlikeWhateverTheirAmplitude) {
  const QImage low = seen({}, waves(20e-6), SurfaceLook::relief);
  const QImage high = seen({}, waves(200e-6), SurfaceLook::relief);
  int most = 0;
  for (int row = 0; row < low.height(); ++row) {
    for (int column = 0; column < low.width(); ++column) {
      most =
          std::max(most, std::abs(qGray(low.pixel(column, row)) - qGray(high.pixel(column, row))));
    }
  }
  EXPECT_LE(most, 2);
}

TEST(WorkspaceView, ANewObjectIsNeverSeenWithTheOldTexture) {
  WorkspaceView view{};
  view.resize(480, 270);
  view.set_object({}, waves(), SurfaceLook::relief);
  ASSERT_TRUE(eventually([&view] { return view.is_drawn(); }));
  view.set_object({}, nullptr, SurfaceLook::plain);
  EXPECT_FALSE(view.is_drawn());
  // The slab's middle is even at once.
  const QImage now = view.grab().toImage();
  int darkest = 255, brightest = 0;
  for (int column = 200; column < 280; ++column) {
    const int grey = qGray(now.pixel(column, 140));
    darkest = std::min(darkest, grey);
    brightest = std::max(brightest, grey);
  }
  EXPECT_LE(brightest - darkest, 2);
}

TEST(WorkspaceView, AnObjectThatLooksTheSameIsNotDrawnAgain) {
  WorkspaceView view{};
  view.resize(480, 270);
  view.set_object({}, waves(), SurfaceLook::pattern);
  ASSERT_TRUE(eventually([&view] { return view.is_drawn(); }));
  view.set_object({}, waves(40e-6, 0.011), SurfaceLook::pattern);
  EXPECT_TRUE(view.is_drawn());
  SurfacePatch larger{};
  larger.extent_m = {0.12, 0.10};
  view.set_object(larger, nullptr, SurfaceLook::pattern);
  EXPECT_FALSE(view.is_drawn());
}

TEST(WorkspaceView, TheToolStandsWhereTheProbeIs) {
  WorkspaceView view{};
  view.resize(480, 270);
  view.set_object({}, nullptr, SurfaceLook::plain);
  ASSERT_TRUE(eventually([&view] { return view.is_drawn(); }));
  const QImage empty = view.grab().toImage();
  view.set_probe(-0.03, 0.0, 0.0, true);
  const QImage left = view.grab().toImage();
  view.set_probe(0.03, 0.0, 0.0, true);
  const QImage right = view.grab().toImage();
  EXPECT_GT(difference(left, empty).pixels, 200);
  EXPECT_LT(difference(left, empty).mean_column + 50, difference(right, empty).mean_column);
  view.take_probe_away();
  EXPECT_EQ(difference(view.grab().toImage(), empty).pixels, 0);
}

// Its shading shows where the end of the tool is, which touches the surface.
TEST(WorkspaceView, TheToolEndsInABallThatIsDarkerAtItsEdge) {
  constexpr double kHeight_m = 0.010;
  constexpr double kRadius_m = 0.0012;
  WorkspaceView view{};
  view.resize(1280, 720);
  view.set_object({}, nullptr, SurfaceLook::plain);
  ASSERT_TRUE(eventually([&view] { return view.is_drawn(); }));
  view.set_probe(0.0, 0.0, kHeight_m, false);
  const QImage seen = view.grab().toImage();
  const WorkspaceCamera camera({}, view.size());
  const glm::dvec3 ball{0.0, 0.0, kHeight_m + kRadius_m};
  const auto grey = [&](double right, double up) {
    const double radius_px = kRadius_m * camera.scale_at(ball);
    const QPointF at = camera.project(ball) + radius_px * QPointF(right, -up);
    return qGray(seen.pixel(at.toPoint()));
  };
  // Along the tool, which has one brightness along its length.
  EXPECT_GT(grey(0.0, 0.0), grey(0.5, 0.65) + 40);
  EXPECT_GT(grey(0.0, 0.0), grey(-0.5, -0.65) + 40);
}

TEST(WorkspaceView, ALeftHandHoldsTheToolFromTheLeft) {
  WorkspaceView view{};
  view.resize(480, 270);
  view.set_object({}, nullptr, SurfaceLook::plain);
  ASSERT_TRUE(eventually([&view] { return view.is_drawn(); }));
  const QImage empty = view.grab().toImage();
  view.set_probe(0.0, 0.0, 0.0, false);
  const double right = difference(view.grab().toImage(), empty).mean_column;
  view.set_mirrored(true);
  const double left = difference(view.grab().toImage(), empty).mean_column;
  EXPECT_GT(right, 240.0);
  EXPECT_LT(left, 240.0);
}

// The eye would tell the hand how soft a surface is.
TEST(WorkspaceView, HowDeepTheProbeIsIsNotSeen) {
  WorkspaceView view{};
  view.resize(480, 270);
  view.set_object({}, nullptr, SurfaceLook::plain);
  ASSERT_TRUE(eventually([&view] { return view.is_drawn(); }));
  view.set_probe(0.01, 0.0, 0.0, true);
  const QImage on = view.grab().toImage();
  view.set_probe(0.01, 0.0, -0.002, true);
  EXPECT_EQ(difference(view.grab().toImage(), on).pixels, 0);
  view.set_probe(0.01, 0.0, 0.010, false);
  EXPECT_GT(difference(view.grab().toImage(), on).pixels, 200);
}

TEST(WorkspaceView, TakesLittleTimeForAFrame) {
  WorkspaceView view{};
  view.resize(1280, 720);
  view.set_object({}, waves(), SurfaceLook::relief);
  QElapsedTimer clock{};
  clock.start();
  ASSERT_TRUE(eventually([&view] { return view.is_drawn(); }));
  std::cout << "the object at 1280 x 720: " << clock.elapsed() << " ms\n";
  QImage frame(view.size(), QImage::Format_RGB32);
  std::vector<double> times_ms{};
  for (int i = 0; i < 200; ++i) {
    view.set_probe(0.04 * std::cos(0.1 * i), 0.04 * std::sin(0.07 * i), 0.01 * std::sin(0.05 * i),
                   true);
    clock.start();
    view.render(&frame);
    times_ms.push_back(static_cast<double>(clock.nsecsElapsed()) * 1e-6);
  }
  std::nth_element(times_ms.begin(), times_ms.begin() + 100, times_ms.end());
  std::cout << "median of 200 frames at 1280 x 720: " << times_ms[100] << " ms\n";
}

using Mesh = std::shared_ptr<const TexturedMesh>;

Mesh made(const Shape& shape, BodyAxis axis, BodyRole role, const HeightField* field) {
  return std::make_shared<const TexturedMesh>(placed(turned(body_mesh(shape, field), axis), role));
}
// Made once: a cylinder takes a second.
const Mesh& plate() {
  static const Mesh kPlate =
      made(PlateShape{{0.04, 0.03, 0.01}}, BodyAxis::z, BodyRole::surface, nullptr);
  return kPlate;
}
const Mesh& wavy_plate() {
  static const Mesh kPlate =
      made(PlateShape{{0.04, 0.03, 0.01}}, BodyAxis::z, BodyRole::surface, waves().get());
  return kPlate;
}
const Mesh& rod() {
  static const Mesh kRod = made(CylinderShape{.diameter_m = 0.006, .length_m = 0.02}, BodyAxis::x,
                                BodyRole::tool, nullptr);
  return kRod;
}

/// A view of two bodies, drawn.
class TwoBodies : public testing::Test {
 protected:
  TwoBodies() { view_.resize(480, 270); }
  QImage seen(const Mesh& surface, const Mesh& tool, SurfaceLook look = SurfaceLook::plain) {
    view_.set_bodies({}, surface, tool, look);
    EXPECT_TRUE(eventually([this] { return view_.is_drawn(); }));
    return now();
  }
  QImage now() { return view_.grab().toImage(); }

  WorkspaceView view_{};
};

int most_levels(const QImage& one, const QImage& other) {
  int most = 0;
  for (int row = 0; row < one.height(); ++row) {
    for (int column = 0; column < one.width(); ++column) {
      most =
          std::max(most, std::abs(qGray(one.pixel(column, row)) - qGray(other.pixel(column, row))));
    }
  }
  return most;
}

// What makes it round is in its displacements, and is no relief.
TEST_F(TwoBodies, ARoundToolThatIsSmoothLooksSmooth) {
  seen(plate(), rod());
  view_.set_probe(0.0, 0.0, 0.0, true);
  const QImage plain = now();
  EXPECT_LE(most_levels(seen(plate(), rod(), SurfaceLook::relief), plain), 6);
}

TEST_F(TwoBodies, TheToolIsSeenWhereItIsAndAsItIsTurned) {
  const QImage empty = seen(plate(), rod());
  view_.set_probe(-0.012, 0.0, 0.0, true);
  const QImage left = now();
  EXPECT_GT(difference(left, empty).pixels, 500);
  view_.set_probe(0.012, 0.0, 0.0, true);
  const QImage right = now();
  EXPECT_LT(difference(left, empty).mean_column + 50, difference(right, empty).mean_column);
  // A quarter turn about the upright axis: from along the picture to into it.
  view_.set_probe_orientation(glm::angleAxis(0.5 * std::numbers::pi, glm::dvec3{0.0, 0.0, 1.0}));
  EXPECT_GT(difference(now(), right).pixels, 500);
  view_.take_probe_away();
  EXPECT_EQ(difference(now(), empty).pixels, 0);
}

TEST_F(TwoBodies, ASurfaceShowsItsReliefOnlyWhereItIsToBeSeen) {
  const Mesh& rough = wavy_plate();
  const QImage relief = seen(rough, rod(), SurfaceLook::relief);
  const QImage plain = seen(rough, rod(), SurfaceLook::plain);
  const QImage pattern = seen(rough, rod(), SurfaceLook::pattern);
  EXPECT_GT(difference(relief, plain).pixels, 10000);
  EXPECT_GT(difference(pattern, plain).pixels, 20);
  const Mesh& smooth = plate();
  // The mesh under a relief has other triangles: at its edges some levels of grey may differ.
  EXPECT_LE(most_levels(seen(smooth, rod(), SurfaceLook::plain), plain), 3);
  EXPECT_LE(most_levels(seen(smooth, rod(), SurfaceLook::pattern), pattern), 8);
}

TEST_F(TwoBodies, ASurfaceInFrontHidesTheTool) {
  const Mesh ball = made(SphereShape{.diameter_m = 0.03}, BodyAxis::z, BodyRole::surface, nullptr);
  const QImage empty = seen(ball, rod());
  // Beside it, and behind it: 48° from above its back is hidden.
  view_.set_probe(0.020, 0.0, -0.015, false);
  const int beside = difference(now(), empty).pixels;
  view_.set_probe(0.0, 0.018, -0.028, false);
  const int behind = difference(now(), empty).pixels;
  EXPECT_LT(behind, beside / 2);
}

// The eye would tell the hand how soft a surface is.
TEST_F(TwoBodies, HowDeepTheToolIsIsNotSeen) {
  seen(plate(), rod());
  view_.set_probe(0.005, 0.0, 0.0, true);
  const QImage on = now();
  view_.set_probe(0.005, 0.0, -0.002, true);
  EXPECT_LT(difference(now(), on).pixels, 10);  // but for rounding at edges
  view_.set_probe(0.005, 0.0, 0.010, false);
  EXPECT_GT(difference(now(), on).pixels, 200);
}

TEST_F(TwoBodies, GiveWayToTheSlabOfAPointAndComeBack) {
  const QImage bodies = seen(plate(), rod());
  view_.set_object({}, nullptr, SurfaceLook::plain);
  ASSERT_TRUE(eventually([this] { return view_.is_drawn(); }));
  EXPECT_GT(difference(now(), bodies).pixels, 10000);
  EXPECT_EQ(difference(seen(plate(), rod()), bodies).pixels, 0);
}

TEST_F(TwoBodies, TakeLittleTimeForAFrame) {
  view_.resize(1280, 720);
  QElapsedTimer clock{};
  clock.start();
  seen(wavy_plate(), rod(), SurfaceLook::relief);
  std::cout << "two bodies at 1280 x 720: " << clock.elapsed() << " ms\n";
  QImage frame(view_.size(), QImage::Format_RGB32);
  std::vector<double> times_ms{};
  for (int i = 0; i < 30; ++i) {
    view_.set_probe(0.015 * std::cos(0.1 * i), 0.01 * std::sin(0.07 * i),
                    0.004 * std::sin(0.05 * i), true);
    clock.start();
    view_.render(&frame);
    times_ms.push_back(static_cast<double>(clock.nsecsElapsed()) * 1e-6);
  }
  std::nth_element(times_ms.begin(), times_ms.begin() + 15, times_ms.end());
  std::cout << "median of 30 frames with two bodies at 1280 x 720: " << times_ms[15] << " ms\n";
}

TEST_F(TwoBodies, LookAsTheyShould) {
  if (qEnvironmentVariableIsEmpty("ASPERITY_SCREENSHOTS")) GTEST_SKIP() << "nobody looks";
  const auto field = waves(100e-6);
  const auto shoot = [&](const Mesh& surface, const Mesh& tool, SurfaceLook look,
                         const glm::dvec3& at, const QString& name, QSize size) {
    view_.resize(size);
    view_.set_probe(at.x, at.y, at.z, at.z <= 0.0);
    seen(surface, tool, look);
    take_screenshot(view_, name, size);
  };
  const Mesh rough_rod = made(CylinderShape{.diameter_m = 0.008, .length_m = 0.012}, BodyAxis::y,
                              BodyRole::tool, field.get());
  const Mesh ball =
      made(SphereShape{.diameter_m = 0.03}, BodyAxis::x, BodyRole::surface, field.get());
  const Mesh log = made(CylinderShape{.diameter_m = 0.02, .length_m = 0.05}, BodyAxis::x,
                        BodyRole::surface, field.get());
  const QSize large(1920, 1080);
  const QSize small(1366, 768);
  shoot(wavy_plate(), rough_rod, SurfaceLook::relief, {0.004, -0.002, 0.0}, "bodies-plate", large);
  shoot(wavy_plate(), rough_rod, SurfaceLook::pattern, {-0.008, 0.0, 0.006}, "bodies-pattern",
        small);
  shoot(log, rod(), SurfaceLook::relief, {0.0, 0.0, 0.0}, "bodies-log", small);
  apply_theme(*qobject_cast<QApplication*>(qApp), ThemeChoice::dark);
  shoot(ball, rough_rod, SurfaceLook::relief, {0.0, 0.0, 0.0}, "bodies-ball-dark", small);
  apply_theme(*qobject_cast<QApplication*>(qApp), ThemeChoice::light);
}

TEST(WorkspaceView, LooksAsItShould) {
  if (qEnvironmentVariableIsEmpty("ASPERITY_SCREENSHOTS")) GTEST_SKIP() << "nobody looks";
  const auto shoot = [](SurfaceLook look, double x_m, double z_m, bool mirrored, QSize size,
                        const QString& name) {
    WorkspaceView view{};
    view.resize(size);
    view.set_object({}, waves(), look);
    view.set_mirrored(mirrored);
    view.set_probe(x_m, -0.008, z_m, z_m <= 0.0);
    EXPECT_TRUE(eventually([&view] { return view.is_drawn(); }));
    take_screenshot(view, name, size);
  };
  const QSize large(1920, 1080);
  const QSize small(1366, 768);
  shoot(SurfaceLook::relief, 0.012, 0.0, false, large, "participant-workspace");
  shoot(SurfaceLook::relief, 0.012, 0.0, false, small, "participant-workspace-small");
  shoot(SurfaceLook::pattern, -0.02, 0.015, true, small, "participant-workspace-pattern");
  shoot(SurfaceLook::plain, 0.03, 0.0, false, small, "participant-workspace-plain");
  apply_theme(*qobject_cast<QApplication*>(qApp), ThemeChoice::dark);
  shoot(SurfaceLook::relief, 0.012, 0.004, false, small, "participant-workspace-dark");
  apply_theme(*qobject_cast<QApplication*>(qApp), ThemeChoice::light);
}

}  // namespace
}  // namespace asperity
