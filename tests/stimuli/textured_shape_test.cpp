// Height fields on shapes: the displaced surface is the shape plus the height.

#include "stimuli/meshes/textured_shape.h"

#include <limits>

#include <gtest/gtest.h>

#include "stimuli/meshes/textured_point.h"
#include "tests/stimuli/made_mesh.h"

namespace asperity::test {
namespace {

/// One wave in x and two in y; a period is 16 mm.
HeightField waves() {
  constexpr std::size_t kSamples = 64;
  std::vector<float> heights_m{};
  for (std::size_t i = 0; i < kSamples; ++i) {
    for (std::size_t j = 0; j < kSamples; ++j) {
      const double turn = 2.0 * std::numbers::pi / kSamples;
      heights_m.push_back(static_cast<float>(1e-4 * std::sin(turn * static_cast<double>(j)) *
                                             std::cos(2.0 * turn * static_cast<double>(i))));
    }
  }
  return HeightField({.rows = kSamples, .columns = kSamples, .pitch_m = 0.00025}, heights_m);
}

HeightField raised(float height_m) {
  return HeightField({.rows = 4, .columns = 4, .pitch_m = 0.002}, std::vector<float>(16, height_m));
}

constexpr ShapeRelief kCoarse{.rim_m = 0.002, .samples_per_wavelength = 4.0};

const std::vector<Shape>& all_shapes() {
  static const std::vector<Shape> shapes{
      PlateShape{{0.03, 0.02, 0.01}}, BoxShape{{0.03, 0.02, 0.01}},
      CylinderShape{.diameter_m = 0.02, .length_m = 0.03}, SphereShape{.diameter_m = 0.02}};
  return shapes;
}

/// `visit` is given points of the textured surface, well within its triangles and on their sides.
void for_points(const TexturedMesh& mesh, const std::function<void(const glm::dvec3&)>& visit) {
  for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
    for (const glm::dvec3& b : {glm::dvec3{1.0 / 3.0}, glm::dvec3{0.61, 0.07, 0.32},
                                glm::dvec3{0.0, 0.45, 0.55}, glm::dvec3{0.25, 0.75, 0.0}}) {
      visit(textured_point_m(mesh, triangle, b));
    }
  }
}

TEST(TexturedShape, IsClosedAndItsNormalsPointOutward) {
  for (const Shape& shape : all_shapes()) {
    const TexturedMesh mesh = textured_shape(shape, raised(1e-4F), kCoarse);
    EXPECT_TRUE(is_closed({mesh.vertices_m, mesh.triangles})) << shape.index();
    EXPECT_GT(volume_m3({mesh.vertices_m, mesh.triangles}), 0.0) << shape.index();
    for (const auto& [a, b, c] : mesh.triangles) {
      const glm::dvec3 front = glm::cross(mesh.vertices_m[b] - mesh.vertices_m[a],
                                          mesh.vertices_m[c] - mesh.vertices_m[a]);
      for (const std::uint32_t corner : {a, b, c}) {
        ASSERT_GT(glm::dot(front, mesh.normals[corner]), 0.0) << shape.index();
      }
    }
    for (const glm::dvec3& normal : mesh.normals) ASSERT_NEAR(glm::length(normal), 1.0, 1e-12);
  }
}

TEST(TexturedShape, OfAPlateLiesAtTheHeightOfTheField) {
  const HeightField field = waves();
  const TexturedMesh mesh = textured_shape(PlateShape{{0.05, 0.04, 0.01}}, field, {});
  std::size_t whole = 0;
  for_points(mesh, [&](const glm::dvec3& point_m) {
    if (point_m.z < -0.001 || std::abs(point_m.x) > 0.023 || std::abs(point_m.y) > 0.018) return;
    ++whole;
    // A wave of 8 mm in texels of 62.5 µm: straight lines in between leave A(πp/λ)²/2 = 3·10⁻⁴ A.
    EXPECT_NEAR(point_m.z, field.sample(point_m.x, point_m.y, Tiling::repeat).height_m, 1e-7);
  });
  EXPECT_GT(whole, 100U);
}

// 37 samples hold five waves, and cells of texels begin and end anywhere in them.
TEST(TexturedShape, NeverStandsOutFurtherThanAGratingThatMeetsItsTexelsAnywhere) {
  constexpr double kHeight_m = 5e-5;
  constexpr std::size_t kSamples = 37;
  std::vector<float> heights_m{};
  for (std::size_t i = 0; i < 2 * kSamples; ++i) {
    const double turns = 5.0 * static_cast<double>(i % kSamples) / kSamples;
    heights_m.push_back(static_cast<float>(kHeight_m * std::sin(2.0 * std::numbers::pi * turns)));
  }
  const HeightField field({.rows = 2, .columns = kSamples, .pitch_m = 0.00013}, heights_m);
  for (const double samples_per_wavelength : {2.0, 2.7, 8.0}) {
    const TexturedMesh mesh =
        textured_shape(PlateShape{{0.02, 0.02, 0.008}}, field,
                       {.rim_m = 0.001, .samples_per_wavelength = samples_per_wavelength});
    double highest_m = 0.0;
    double furthest_m = 0.0;
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
      for (int i = 0; i <= 60; ++i) {
        for (int j = 0; i + j <= 60; j += 7) {
          const glm::dvec3 p_m =
              textured_point_m(mesh, triangle, glm::dvec3{60.0 - i - j, i, j} / 60.0);
          if (p_m.z < -0.001 || std::abs(p_m.x) > 0.0085 || std::abs(p_m.y) > 0.0085) continue;
          highest_m = std::max(highest_m, std::abs(p_m.z));
          const double height_m = field.sample(p_m.x, p_m.y, Tiling::repeat).height_m;
          furthest_m = std::max(furthest_m, std::abs(p_m.z - height_m));
        }
      }
    }
    EXPECT_GT(highest_m, 0.97 * kHeight_m);
    EXPECT_LE(highest_m, kHeight_m + 1e-8);
    // 7.4 samples a wave, so many texels or more: (π/7.4)²/2 of straight lines at a crest.
    EXPECT_LT(furthest_m, 0.09 * kHeight_m);
  }
}

TEST(TexturedShape, OfABoxRisesOnEverySideAndIsBareAtItsEdges) {
  // Straight lines between texels of 125 µm round the ends of the rise off: 6 h/w²·p²/8, 1.2 µm.
  const TexturedMesh mesh = textured_shape(BoxShape{{0.03, 0.02, 0.01}}, raised(1e-4F), kCoarse);
  const glm::dvec3 half_m{0.015, 0.01, 0.005};
  std::array<std::size_t, 3> risen{};
  for_points(mesh, [&](const glm::dvec3& point_m) {
    for (int axis = 0; axis < 3; ++axis) {
      const int u = (axis + 1) % 3;
      const int v = (axis + 2) % 3;
      const double above_m = std::abs(point_m[axis]) - half_m[axis];
      EXPECT_LT(above_m, 1e-4 + 1e-8);
      const double from_edge_m =
          std::min(half_m[u] - std::abs(point_m[u]), half_m[v] - std::abs(point_m[v]));
      if (above_m < -1e-9 || from_edge_m <= 0.0) continue;
      if (from_edge_m >= 0.002) {
        EXPECT_NEAR(above_m, 1e-4, 2e-6);
        ++risen[static_cast<std::size_t>(axis)];
      }
      if (from_edge_m <= 0.001) {
        EXPECT_NEAR(above_m, 0.0, 2e-6);
      }
    }
  });
  for (const std::size_t count : risen) EXPECT_GT(count, 4U);
}

TEST(TexturedShape, OfACylinderIsRoundAndTheFieldClosesAroundIt) {
  const HeightField field = waves();
  const TexturedMesh mesh =
      textured_shape(CylinderShape{.diameter_m = 0.02, .length_m = 0.03}, field, kCoarse);
  // The circumference, 62.8 mm, is four periods of 16 mm but for 2 %.
  std::size_t whole = 0;
  for_points(mesh, [&](const glm::dvec3& point_m) {
    const double from_axis_m = std::hypot(point_m.x, point_m.y);
    if (std::abs(point_m.z) > 0.0129 || from_axis_m < 0.0095) return;
    const double turns = std::atan2(point_m.y, point_m.x) / (2.0 * std::numbers::pi);
    EXPECT_NEAR(from_axis_m,
                0.01 + field.sample(turns * 4.0 * 0.016, point_m.z, Tiling::repeat).height_m, 3e-7);
    ++whole;
  });
  EXPECT_GT(whole, 100U);
}

TEST(TexturedShape, OfASphereIsRoundAndSmoothAtItsPoles) {
  const TexturedMesh mesh = textured_shape(SphereShape{.diameter_m = 0.02}, raised(1e-4F), kCoarse);
  for_points(mesh, [](const glm::dvec3& point_m) {
    const double radius_m = glm::length(point_m);
    const double latitude_deg = std::asin(point_m.z / radius_m) * 180.0 / std::numbers::pi;
    if (std::abs(latitude_deg) < 59.0) {
      EXPECT_NEAR(radius_m, 0.0101, 5e-7);
    } else if (std::abs(latitude_deg) > 76.0) {
      EXPECT_NEAR(radius_m, 0.01, 5e-7);
    }
  });
}

TEST(TexturedShape, RefusesWhatCannotBeMade) {
  const HeightField field = waves();
  const auto refuses = [&](const Shape& shape, const ShapeRelief& relief) {
    EXPECT_THROW(textured_shape(shape, field, relief), std::invalid_argument) << shape.index();
    EXPECT_THROW(require_textured_shape(shape, field, relief), std::invalid_argument)
        << shape.index();
  };
  refuses(PlateShape{{0.03, 0.0, 0.01}}, kCoarse);
  refuses(BoxShape{{0.03, 11.0, 0.01}}, kCoarse);
  refuses(CylinderShape{.diameter_m = -0.02, .length_m = 0.03}, kCoarse);
  refuses(SphereShape{.diameter_m = std::numeric_limits<double>::quiet_NaN()}, kCoarse);
  refuses(SphereShape{.diameter_m = 0.02}, {.rim_m = 0.006});
  refuses(BoxShape{{0.03, 0.02, 0.01}}, {.rim_m = 0.0});
  refuses(BoxShape{{0.03, 0.02, 0.01}}, {.samples_per_wavelength = 0.5});
  refuses(PlateShape{{2.0, 2.0, 0.02}}, {});  // texels of 62.5 µm on 4 m²
  // Cells of texels that would be too many by themselves.
  const HeightField fine({.rows = 2, .columns = 2, .pitch_m = 1e-8}, std::vector<float>(4, 0.0F));
  EXPECT_THROW(require_textured_shape(BoxShape{{1.0, 1.0, 1.0}}, fine, {}), std::invalid_argument);
  EXPECT_THROW(require_textured_shape(CylinderShape{.diameter_m = 0.1, .length_m = 10.0}, fine, {}),
               std::invalid_argument);
  for (const Shape& shape : all_shapes())
    EXPECT_NO_THROW(require_textured_shape(shape, field, kCoarse));
}

}  // namespace
}  // namespace asperity::test
