// Bodies whose contacts begin, merge, divide and end, and the forces between them.

#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <span>

#include <glm/geometric.hpp>

#include "renderers/pd_gradient/contact/textured_contacts.h"
#include "tests/renderers/meshes.h"
#include "tests/renderers/textured_bodies.h"

namespace asperity {

inline WindowSampling hard(double step_m, int cells = 1) {
  return {.law = HardMaximum{.step_m = step_m}, .cell_m = step_m / cells, .most_samples = 512};
}

inline TexturedContacts between(const TexturedMesh& a, const TexturedMesh& b,
                                const WindowSampling& sampling) {
  return {{a, 1.0}, {b, 1.0}, sampling, instruction_sets_here().back()};
}

/// The force on A, and its torque about a point of the world.
inline Wrench wrench_about(const glm::dvec3& point_m, std::span<const TexturedContact> contacts) {
  Wrench sum{};
  for (const TexturedContact& contact : contacts) {
    const Wrench one =
        contact_wrench(contact.penetration, contact.frame, contact.share * kStiffness_N_per_m);
    sum.force_N += one.force_N;
    sum.torque_N_m += one.torque_N_m + glm::cross(contact.frame.origin_m - point_m, one.force_N);
  }
  return sum;
}

/// Balls as one body.
inline TexturedMesh balls_at(std::initializer_list<glm::dvec3> middles_m, double radius_m) {
  const TriangleMesh one = ball(radius_m, 12, 16);
  TriangleMesh all;
  for (const glm::dvec3& middle_m : middles_m) {
    const auto first = static_cast<std::uint32_t>(all.vertices_m.size());
    for (const glm::dvec3& vertex_m : one.vertices_m) all.vertices_m.push_back(vertex_m + middle_m);
    for (const auto& [a, b, c] : one.triangles) {
      all.triangles.push_back({a + first, b + first, c + first});
    }
  }
  return bare(all);
}

/// The radius of a needle's tip.
inline constexpr double kNeedle_m = 0.25e-3;

/// A needle of 8.5 mm that points down, with the middle of its tip at the origin.
inline TriangleMesh needle() {
  TriangleMesh mesh = ball(kNeedle_m, 8, 12);
  for (glm::dvec3& vertex_m : mesh.vertices_m) {
    if (vertex_m.z > 0.0) vertex_m.z += 8e-3;
  }
  return mesh;
}

/// Two sheets of that thickness, their middles `gap_m` apart, the upper one's at zero.
inline TriangleMesh two_sheets(double thickness_m, double gap_m) {
  TriangleMesh sheets = box({0.02, 0.02, thickness_m});
  const TriangleMesh lower = sheets;
  for (const glm::dvec3& vertex_m : lower.vertices_m) {
    sheets.vertices_m.push_back(vertex_m - glm::dvec3{0.0, 0.0, gap_m});
  }
  for (const auto& [p, q, r] : lower.triangles) sheets.triangles.push_back({p + 8, q + 8, r + 8});
  return sheets;
}

/// A floor, and at x = 0 a wall of that angle and height.
inline TriangleMesh floor_and_wall(double angle_rad, double high_m = 40e-3) {
  const double run_m = high_m / std::tan(angle_rad);
  TriangleMesh step;
  for (const double y_m : {-10e-3, 10e-3}) {
    for (const glm::dvec2& place_m : std::array<glm::dvec2, 6>{{{-10e-3, -5e-3},
                                                                {40e-3, -5e-3},
                                                                {40e-3, high_m},
                                                                {run_m, high_m},
                                                                {0.0, 0.0},
                                                                {-10e-3, 0.0}}}) {
      step.vertices_m.push_back({place_m.x, y_m, place_m.y});
    }
  }
  for (std::uint32_t i = 0; i < 6; ++i) {
    const std::uint32_t next = (i + 1) % 6;
    step.triangles.push_back({i, next + 6, next});
    step.triangles.push_back({i, i + 6, next + 6});
  }
  for (const auto& [a, b, c] :
       std::array<std::array<std::uint32_t, 3>, 4>{{{0, 1, 4}, {0, 4, 5}, {1, 2, 4}, {2, 3, 4}}}) {
    step.triangles.push_back({a, b, c});
    step.triangles.push_back({a + 6, c + 6, b + 6});
  }
  return step;
}

/// A contact without a share, as one of a doubtful depth, is not among those of a tick.
inline bool is_first_felt(std::span<const TexturedContact> found) {
  return !found.empty() && is_felt(found[0]);
}

}  // namespace asperity
