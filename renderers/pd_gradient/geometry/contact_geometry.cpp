// Implements the checks of a frame, a grid, a mesh and a patch.

#include "renderers/pd_gradient/geometry/contact_geometry.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace asperity {
namespace {

constexpr double kUnitTolerance = 1e-9;

bool finite(const glm::dvec2& v) { return std::isfinite(v.x) && std::isfinite(v.y); }
bool finite(const glm::dvec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

[[noreturn]] void refuse(const std::string& sentence) { throw std::invalid_argument(sentence); }

}  // namespace

Pose operator*(const Pose& X_AB, const Pose& X_BC) noexcept {
  return {.rotation = X_AB.rotation * X_BC.rotation, .position_m = X_AB * X_BC.position_m};
}

glm::dvec3 operator*(const Pose& X_AB, const glm::dvec3& p_BP_m) noexcept {
  return X_AB.rotation * p_BP_m + X_AB.position_m;
}

Pose inverse(const Pose& X_AB) noexcept {
  const glm::dmat3 back = glm::transpose(X_AB.rotation);
  return {.rotation = back, .position_m = -(back * X_AB.position_m)};
}

glm::dvec3 ContactFrame::to_frame(const glm::dvec3& world) const noexcept {
  return {glm::dot(world, u), glm::dot(world, v), glm::dot(world, n)};
}

glm::dvec3 ContactFrame::to_world(const glm::dvec3& frame) const noexcept {
  return frame.x * u + frame.y * v + frame.z * n;
}

double sunk_m(double cosine, double leaning_cosine, double window_m) noexcept {
  if (cosine >= leaning_cosine) return 0.0;
  const double left = cosine - 0.5 * leaning_cosine;
  if (left <= 0.0) return std::numeric_limits<double>::infinity();
  return 0.5 * window_m * (leaning_cosine - cosine) / left;
}

void require_sound(const ContactFrame& frame) {
  const auto is = [](double value, double wanted) {
    return std::abs(value - wanted) <= kUnitTolerance;  // false for NaN
  };
  if (!finite(frame.origin_m))
    refuse("ContactFrame: origin_m is not finite; its coordinates must be finite.");
  if (!is(glm::dot(frame.u, frame.u), 1.0) || !is(glm::dot(frame.v, frame.v), 1.0) ||
      !is(glm::dot(frame.u, frame.v), 0.0) ||
      !is(glm::dot(glm::cross(frame.u, frame.v), frame.n), 1.0) ||
      !is(glm::dot(frame.n, frame.n), 1.0)) {
    refuse(
        "ContactFrame: u, v and n are not orthonormal; they must be unit vectors at right angles, "
        "n = u × v.");
  }
}

void require_sound(const SamplingGrid& grid) {
  if (!(grid.width_m > 0.0) || !std::isfinite(grid.width_m)) {
    refuse("SamplingGrid: width_m is " + std::to_string(grid.width_m) + "; it must be positive.");
  }
  if (grid.samples < 2) {
    refuse("SamplingGrid: samples is " + std::to_string(grid.samples) + "; at least 2 are needed.");
  }
}

void require_sound(const TexturedMesh& mesh) {
  if (mesh.normals.size() != mesh.vertices_m.size()) {
    refuse("TexturedMesh: the number of vertices is " + std::to_string(mesh.vertices_m.size()) +
           " and that of normals is " + std::to_string(mesh.normals.size()) +
           "; they must be equal.");
  }
  if (mesh.places.size() != mesh.triangles.size()) {
    refuse("TexturedMesh: the number of triangles is " + std::to_string(mesh.triangles.size()) +
           " and that of places is " + std::to_string(mesh.places.size()) +
           "; they must be equal.");
  }
  const DisplacementAtlas& atlas = mesh.atlas;
  if (atlas.rows == 0 || atlas.columns == 0 || atlas.values.size() != atlas.rows * atlas.columns) {
    refuse("TexturedMesh: an atlas of " + std::to_string(atlas.rows) + " × " +
           std::to_string(atlas.columns) + " texels: the number of values is " +
           std::to_string(atlas.values.size()) +
           "; it must be that of the texels, and at least one.");
  }
  if (!std::isfinite(atlas.step_m))
    refuse("TexturedMesh: step_m of the atlas is not finite; it must be finite.");
  for (std::size_t i = 0; i < mesh.vertices_m.size(); ++i) {
    if (!finite(mesh.vertices_m[i]) || !finite(mesh.normals[i])) {
      refuse("TexturedMesh: vertex " + std::to_string(i) +
             " or its normal is not finite; all must be finite.");
    }
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      if (mesh.triangles[i][corner] >= mesh.vertices_m.size()) {
        refuse("TexturedMesh: triangle " + std::to_string(i) + " refers to vertex " +
               std::to_string(mesh.triangles[i][corner]) +
               "; it must be less than the number of vertices, " +
               std::to_string(mesh.vertices_m.size()) + ".");
      }
      if (!finite(mesh.places[i][corner])) {
        refuse("TexturedMesh: a place of triangle " + std::to_string(i) +
               " is not finite; all must be finite.");
      }
    }
  }
}

void require_sound(const ContactPatch& patch) {
  require_sound(patch.mesh);
  const glm::dmat3& rotation = patch.pose.rotation;
  if (!finite(patch.pose.position_m) || !finite(rotation[0]) || !finite(rotation[1]) ||
      !finite(rotation[2])) {
    refuse("ContactPatch: pose is not finite; position and rotation must be finite.");
  }
  for (const std::uint32_t triangle : patch.triangles) {
    if (triangle >= patch.mesh.triangles.size()) {
      refuse("ContactPatch: triangle " + std::to_string(triangle) +
             " does not exist; it must be less than the number of triangles of the mesh, " +
             std::to_string(patch.mesh.triangles.size()) + ".");
    }
  }
}

}  // namespace asperity
