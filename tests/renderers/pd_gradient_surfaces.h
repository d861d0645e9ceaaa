// Surfaces for the tests of contacts: formed plates, textured plates, and contacts by chance.

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "analysis/numbers/random.h"
#include "renderers/pd_gradient/geometry/contact_geometry.h"
#include "stimuli/meshes/textured_mesh.h"

namespace asperity {

inline std::vector<std::uint32_t> all_triangles(const TexturedMesh& mesh) {
  std::vector<std::uint32_t> triangles(mesh.triangles.size());
  std::iota(triangles.begin(), triangles.end(), 0U);
  return triangles;
}

inline constexpr double kStiffness_N_per_m = 1000.0;

inline double relative(const glm::dvec3& difference, const glm::dvec3& whole) {
  return glm::length(difference) / glm::length(whole);
}

inline Pose pose_at(const glm::dvec3& position_m) { return {.position_m = position_m}; }

// Turned over about the x-axis: what looked up looks down; (x, y, z) → (x, −y, −z).
inline Pose upside_down(const glm::dvec3& position_m) {
  return {.rotation = glm::dmat3(1, 0, 0, 0, -1, 0, 0, 0, -1), .position_m = position_m};
}

inline glm::dmat3 turn_about(const glm::dvec3& axis, double angle_rad) {
  return glm::mat3_cast(glm::angleAxis(angle_rad, glm::normalize(axis)));
}

struct FormedPlate {
  glm::dvec2 size_m{0.0};
  std::array<std::size_t, 2> cells{1, 1};
};

// A plate about the origin that looks up, with vertices at height(x, y), and no texture.
template <typename Height>
TexturedMesh formed_plate(const FormedPlate& shape, const Height& height) {
  TexturedMesh mesh;
  const auto [columns, rows] = shape.cells;
  for (std::size_t row = 0; row <= rows; ++row) {
    for (std::size_t column = 0; column <= columns; ++column) {
      const double x_m =
          (static_cast<double>(column) / static_cast<double>(columns) - 0.5) * shape.size_m.x;
      const double y_m =
          (static_cast<double>(row) / static_cast<double>(rows) - 0.5) * shape.size_m.y;
      mesh.vertices_m.push_back({x_m, y_m, height(x_m, y_m)});
      mesh.normals.push_back({0.0, 0.0, 1.0});
    }
  }
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      const auto a = static_cast<std::uint32_t>(row * (columns + 1) + column);
      const auto above = static_cast<std::uint32_t>(a + columns + 1);
      mesh.triangles.push_back({a, a + 1, above + 1});
      mesh.triangles.push_back({a, above + 1, above});
    }
  }
  mesh.places.assign(mesh.triangles.size(), {});
  mesh.atlas = {.rows = 1, .columns = 1, .step_m = 0.0, .values = {0}};
  return mesh;
}

// Gives a plate the texture displacement(x, y), with texels that far apart and a margin around.
template <typename Displacement>
void put_texture(TexturedMesh& plate, double size_m, double texel_m,
                 const Displacement& displacement) {
  constexpr double kMargin = 2.0;
  const auto side = static_cast<std::size_t>(std::ceil(size_m / texel_m) + 2.0 * kMargin + 1.0);
  std::vector<double> values_m;
  double largest_m = 1e-12;
  for (std::size_t row = 0; row < side; ++row) {
    for (std::size_t column = 0; column < side; ++column) {
      values_m.push_back(
          displacement((static_cast<double>(column) - kMargin) * texel_m - size_m / 2,
                       (static_cast<double>(row) - kMargin) * texel_m - size_m / 2));
      largest_m = std::max(largest_m, std::abs(values_m.back()));
    }
  }
  plate.atlas = {.rows = side, .columns = side, .step_m = largest_m / 32767.0};
  for (const double value_m : values_m) {
    plate.atlas.values.push_back(
        static_cast<std::int16_t>(std::lround(value_m / plate.atlas.step_m)));
  }
  for (std::size_t i = 0; i < plate.triangles.size(); ++i) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const glm::dvec3 p_m = plate.vertices_m[plate.triangles[i][corner]];
      plate.places[i][corner] = (glm::dvec2{p_m} + size_m / 2) / texel_m + kMargin;
    }
  }
}

template <typename Displacement>
TexturedMesh textured_plate(double size_m, double texel_m, const Displacement& displacement) {
  TexturedMesh plate =
      formed_plate({.size_m = glm::dvec2(size_m)}, [](double, double) { return 0.0; });
  put_texture(plate, size_m, texel_m, displacement);
  return plate;
}

// Vertex normals as the area-weighted mean of the faces around.
inline void set_normals(TexturedMesh& mesh) {
  mesh.normals.assign(mesh.vertices_m.size(), glm::dvec3(0.0));
  for (const auto& [a, b, c] : mesh.triangles) {
    const glm::dvec3 normal = glm::cross(mesh.vertices_m[b] - mesh.vertices_m[a],
                                         mesh.vertices_m[c] - mesh.vertices_m[a]);
    for (const std::uint32_t vertex : {a, b, c}) mesh.normals[vertex] += normal;
  }
  for (glm::dvec3& normal : mesh.normals) normal = glm::normalize(normal);
}

// What touches in a contact by chance: the kinds differ in how many places compete to be deepest.
enum class ContactKind { flat, convex_on_flat, convex_on_convex, conforming, ridge, overlapping };
inline constexpr std::array<ContactKind, 6> kContactKinds = {
    ContactKind::flat,       ContactKind::convex_on_flat, ContactKind::convex_on_convex,
    ContactKind::conforming, ContactKind::ridge,          ContactKind::overlapping};

struct ChanceContact {
  TexturedMesh mesh_a{};
  TexturedMesh mesh_b{};
  std::vector<std::uint32_t> triangles_a{};
  std::vector<std::uint32_t> triangles_b{};
  Pose pose_a{};
  Pose pose_b{};

  ContactPatch a() const { return {.mesh = mesh_a, .triangles = triangles_a, .pose = pose_a}; }
  ContactPatch b() const { return {.mesh = mesh_b, .triangles = triangles_b, .pose = pose_b}; }
};

// Two low-resolution plates with rough textures, one upside down over the other, about touching at
// height 0 around the origin. The window is eight of the textures' shortest wavelengths wide.
class ContactsByChance final {
 public:
  static constexpr double kShortest_m = 0.001;
  static constexpr double kWindow_m = 8.0 * kShortest_m;
  static constexpr double kRms_m = kShortest_m / 10.0;

  explicit ContactsByChance(std::uint64_t seed) : random_(seed) {}

  ChanceContact draw(ContactKind kind) {
    double curved_a_per_m = 0.0;
    double curved_b_per_m = 0.0;
    double ridge = 0.0;
    switch (kind) {
      case ContactKind::flat:
        break;
      case ContactKind::overlapping:
      case ContactKind::convex_on_flat:
        curved_a_per_m = between(12.0, 80.0);
        break;
      case ContactKind::convex_on_convex:
        curved_a_per_m = between(12.0, 80.0);
        curved_b_per_m = between(12.0, 80.0);
        break;
      case ContactKind::conforming:
        curved_a_per_m = between(25.0, 80.0);
        curved_b_per_m = -between(6.0, 20.0);
        break;
      case ContactKind::ridge:
        ridge = between(0.05, 0.25);
        break;
    }
    ChanceContact contact;
    contact.mesh_a = plate(curved_a_per_m, ridge);
    contact.mesh_b = plate(curved_b_per_m, 0.0);
    contact.triangles_a = all_triangles(contact.mesh_a);
    contact.triangles_b = all_triangles(contact.mesh_b);
    const double aside_m = (kind == ContactKind::overlapping ? 0.45 : 0.03) * kWindow_m;
    const double tilt_rad = kind == ContactKind::flat ? 0.01 : 0.03;
    contact.pose_a = upside_down({between(-aside_m, aside_m), between(-aside_m, aside_m), 0.0});
    contact.pose_a.rotation = turn_about({1, 0, 0}, between(-tilt_rad, tilt_rad)) *
                              turn_about({0, 1, 0}, between(-tilt_rad, tilt_rad)) *
                              turn_about({0, 0, 1}, between(-3.0, 3.0)) * contact.pose_a.rotation;
    return contact;
  }

  double between(double low, double high) { return low + (high - low) * random_.uniform(); }

 private:
  // Convex with the curvature, with a ridge of that slope, on two to five squares a side.
  TexturedMesh plate(double curvature_per_m, double ridge) {
    constexpr double kSize_m = 1.5 * kWindow_m;  // turned by 45° it still fills the window
    const auto cells = static_cast<std::size_t>(between(2.0, 5.99));
    const double towards_rad = between(0.0, std::numbers::pi);
    TexturedMesh mesh = formed_plate(
        {.size_m = glm::dvec2(kSize_m), .cells = {cells, cells}}, [&](double x_m, double y_m) {
          return -0.5 * curvature_per_m * (x_m * x_m + y_m * y_m) -
                 ridge * std::abs(std::cos(towards_rad) * x_m + std::sin(towards_rad) * y_m) +
                 between(0.0, 1e-5);
        });
    set_normals(mesh);
    struct Wave {
      glm::dvec2 per_m{0.0};
      double height_m = 0.0;
      double phase_rad = 0.0;
    };
    std::vector<Wave> waves(32);
    double variance_m2 = 0.0;
    for (Wave& wave : waves) {
      const double wavelength_m = kShortest_m * std::pow(8.0, random_.uniform());
      const double angle_rad = between(0.0, 2.0 * std::numbers::pi);
      wave.per_m = 2.0 * std::numbers::pi / wavelength_m *
                   glm::dvec2{std::cos(angle_rad), std::sin(angle_rad)};
      wave.height_m = std::pow(wavelength_m / kShortest_m, 0.8);
      wave.phase_rad = between(0.0, 2.0 * std::numbers::pi);
      variance_m2 += 0.5 * wave.height_m * wave.height_m;
    }
    for (Wave& wave : waves) wave.height_m *= kRms_m / std::sqrt(variance_m2);
    put_texture(mesh, kSize_m, kShortest_m / 8.0, [&](double x_m, double y_m) {
      double sum_m = 0.0;
      for (const Wave& wave : waves) {
        sum_m +=
            wave.height_m * std::cos(glm::dot(wave.per_m, glm::dvec2{x_m, y_m}) + wave.phase_rad);
      }
      return sum_m;
    });
    return mesh;
  }

  Random random_;
};

}  // namespace asperity
