// Implements the decimation: the restrictions one after the other, and the cutting of handles.

#include "stimuli/meshes/mesh_decimation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "analysis/numbers/number_text.h"
#include "stimuli/meshes/decimation/batches.h"
#include "stimuli/meshes/decimation/best_collapse.h"
#include "stimuli/meshes/decimation/closed_surface.h"
#include "stimuli/meshes/decimation/vertex_past.h"
#include "stimuli/meshes/mesh_handles.h"

namespace asperity {

namespace {

using decimation::Permission;
using decimation::Quadric;
using decimation::Strictness;
using decimation::VertexPast;

constexpr std::size_t kFewestTriangles = 4;  // a tetrahedron

/// What is permitted first, and then step by step if that is not sufficient.
std::vector<Permission> permissions() {
  constexpr double kClose = 0.001;
  constexpr double kFurthest = 1.0;  // no point is as far from a mesh as its size
  std::vector<Permission> result{};
  for (double furthest = kClose; furthest < kFurthest; furthest *= 2.0) {
    result.push_back({Strictness::turn_and_shape, furthest});
    result.push_back({Strictness::look, furthest});
  }
  return result;
}

/// Reports the fraction of the triangles that have been removed; it does not decrease where a cut adds some.
class Course final {
 public:
  Course(std::size_t from, std::size_t to, const std::function<void(double)>& progress)
      : from_(from), to_(to), progress_(progress) {}
  void reached(std::size_t triangles) {
    if (!progress_) return;
    const double removed = triangles < from_ ? static_cast<double>(from_ - triangles) : 0.0;
    fraction_ = std::max(fraction_, std::min(1.0, removed / static_cast<double>(from_ - to_)));
    progress_(fraction_);
  }

 private:
  std::size_t from_;
  std::size_t to_;
  const std::function<void(double)>& progress_;
  double fraction_ = 0.0;
};

/// The position and size of a mesh, for computation about the origin at unit size.
struct Place {
  glm::dvec3 centre_m{};
  double size_m = 1.0;
};

Place place_of(const TriangleMesh& mesh) {
  glm::dvec3 low_m = mesh.vertices_m.front();
  glm::dvec3 high_m = low_m;
  for (const glm::dvec3& point_m : mesh.vertices_m) {
    low_m = glm::min(low_m, point_m);
    high_m = glm::max(high_m, point_m);
  }
  return {0.5 * (low_m + high_m), glm::length(high_m - low_m)};
}

/// The mesh during its simplification, about the origin and at unit size.
class Simplification final {
 public:
  Simplification(const TriangleMesh& mesh, const std::string& name, unsigned jobs)
      : place_(place_of(mesh)), mesh_(mesh), name_(name), jobs_(jobs) {
    for (glm::dvec3& point : mesh_.vertices_m) point = (point - place_.centre_m) / place_.size_m;
    pasts_.resize(mesh_.vertices_m.size());
    for (std::uint32_t i = 0; i < pasts_.size(); ++i) {
      pasts_[i].origin = i;
      pasts_[i].samples.push_back({.place = point(i)});
    }
    for (const std::array<std::uint32_t, 3>& triangle : mesh_.triangles) remember(triangle);
    for (std::uint32_t i = 0; i < pasts_.size(); ++i) {
      VertexPast& past = pasts_[i];
      if (const double length = glm::length(past.normal); length > 0.0) past.normal /= length;
      past.deviation = past.quadric.at(point(i));
    }
  }

  std::size_t triangles() const { return mesh_.triangles.size(); }

  /// Collapses edges down to at most `wanted` triangles, or as far as the last permission allows.
  void collapse_to(std::size_t wanted, const std::vector<Permission>& permissions, Course& course) {
    if (triangles() <= wanted) return;
    decimation::ClosedSurface surface(mesh_);
    if (const auto fault = surface.first_fault()) {
      throw std::invalid_argument(name_ + " has a non-manifold surface at vertex " +
                                  std::to_string(pasts_[*fault].origin) +
                                  " that repair did not detect. Correct the mesh there.");
    }
    decimation::Batches batches(surface, pasts_, jobs_);
    for (const Permission& permission : permissions) {
      course.reached(surface.triangles());
      if (surface.triangles() <= wanted) break;
      batches.run(wanted, permission, [&] { course.reached(surface.triangles()); });
    }
    take(surface);
  }

  /// Cuts handles that are narrower than the side of a face in a mesh of `triangles` faces.
  void cut_handles(std::size_t triangles, SimplifiedMesh& result) {
    const double side = std::sqrt(4.0 * area_ / (std::sqrt(3.0) * static_cast<double>(triangles)));
    const HandleCuts cuts = cut_narrow_handles(mesh_, side);
    for (const std::uint32_t copied : cuts.copies) {
      VertexPast copy = pasts_[copied];
      copy.samples.clear();  // the area of the surface is unchanged
      pasts_.push_back(std::move(copy));
    }
    result.handles_cut += cuts.handles;
    result.widest_handle_m = std::max(result.widest_handle_m, place_.size_m * cuts.widest_m);
  }

  TriangleMesh with_vertices_of(const TriangleMesh& given) const {
    TriangleMesh result{.vertices_m = {}, .triangles = mesh_.triangles};
    for (const VertexPast& past : pasts_) {
      result.vertices_m.push_back(given.vertices_m[past.origin]);
    }
    return result;
  }

 private:
  const glm::dvec3& point(std::uint32_t vertex) const { return mesh_.vertices_m[vertex]; }

  /// A vertex represents a third of the area of its faces. Its normal is their mean, weighted by angle: weighted by
  /// area, the normal at a corner between a large and a small face would be that of the large one.
  void remember(const std::array<std::uint32_t, 3>& triangle) {
    const auto& [a, b, c] = triangle;
    const glm::dvec3 area = glm::cross(point(b) - point(a), point(c) - point(a));
    const double size = glm::length(area);
    if (size <= 0.0) return;
    area_ += 0.5 * size;
    const glm::dvec3 normal = area / size;
    const Quadric quadric(normal, point(a), 0.5 * size);
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::dvec3 one = point(triangle[(i + 1) % 3]) - point(triangle[i]);
      const glm::dvec3 other = point(triangle[(i + 2) % 3]) - point(triangle[i]);
      VertexPast& past = pasts_[triangle[i]];
      past.quadric += quadric;
      past.samples.front().area += size / 6.0;
      past.normal += std::atan2(size, glm::dot(one, other)) * normal;
    }
  }

  void take(const decimation::ClosedSurface& surface) {
    decimation::ClosedSurface::Remaining remaining = surface.remaining();
    std::vector<VertexPast> pasts{};
    pasts.reserve(remaining.vertices.size());
    for (const std::uint32_t vertex : remaining.vertices) {
      pasts.push_back(std::move(pasts_[vertex]));
    }
    mesh_ = std::move(remaining.mesh);
    pasts_ = std::move(pasts);
  }

  Place place_{};
  TriangleMesh mesh_{};
  const std::string& name_;
  unsigned jobs_;
  std::vector<VertexPast> pasts_{};
  double area_ = 0.0;
};

}  // namespace

SimplifiedMesh decimate_mesh(const TriangleMesh& mesh, std::size_t triangles,
                             const std::string& name, const Workers& workers) {
  if (triangles < kFewestTriangles) {
    throw std::invalid_argument(name + " cannot be simplified to " +
                                counted(triangles, "triangle", "triangles") +
                                ": a closed mesh has at least 4. Request at least that many.");
  }
  if (triangles > mesh.triangles.size()) {
    throw std::invalid_argument(name + " cannot be simplified to " + std::to_string(triangles) +
                                " triangles: it has only " + std::to_string(mesh.triangles.size()) +
                                ". Request at most that many.");
  }
  SimplifiedMesh result{};
  if (triangles == mesh.triangles.size()) {
    result.mesh = mesh;
    return result;
  }
  Course course(mesh.triangles.size(), triangles, workers.progress);
  Simplification simple(mesh, name, workers.jobs);
  std::vector<Permission> permitted = permissions();
  // A handle can neither close nor open and would occupy an increasing fraction of the remaining faces. It is cut when
  // the surrounding faces are as large as the handle.
  const bool has_handles = handles_of(mesh) > 0;
  for (const std::size_t times : {32U, 16U, 8U, 4U, 2U}) {
    if (!has_handles || simple.triangles() <= times * triangles) continue;
    simple.collapse_to(times * triangles, permitted, course);
    simple.cut_handles(triangles, result);
  }
  permitted.push_back({Strictness::flip_only, permitted.back().furthest});
  simple.collapse_to(triangles, permitted, course);
  if (simple.triangles() > triangles) {
    throw std::invalid_argument(
        name + " cannot be simplified to " + std::to_string(triangles) + " triangles: at " +
        std::to_string(simple.triangles()) +
        " no further edge can be removed without inverting a face or closing a "
        "part or a handle. Request at least that many.");
  }
  result.mesh = simple.with_vertices_of(mesh);
  return result;
}

std::optional<std::string> sentence_of(const SimplifiedMesh& simplified) {
  if (simplified.handles_cut == 0) return std::nullopt;
  return "Handles and tunnels cut because they were narrower than a face, up to " +
         fixed(1e3 * simplified.widest_handle_m, 3) +
         " mm in circumference: " + std::to_string(simplified.handles_cut) + '.';
}

}  // namespace asperity
