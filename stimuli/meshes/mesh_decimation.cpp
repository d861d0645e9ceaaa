// Implements the decimation with OpenMesh's half-edges, heap and legality checks, and with a separate cost and separate
// restrictions of the collapses.
//
// OpenMesh's ModQuadric treats an error that rounding makes negative as a rejection, which affects every second
// collapse on flat faces; its ModNormalFlipping forbids every collapse next to a face of zero area.

#include "stimuli/meshes/mesh_decimation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

// QuadricT.hh does not include the header that it requires.
// clang-format off
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Geometry/QuadricT.hh>
// clang-format on
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModBaseT.hh>
#include <OpenMesh/Tools/Decimater/Observer.hh>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "analysis/number_text.h"
#include "stimuli/meshes/mesh_handles.h"
#include "stimuli/meshes/surface_search.h"

namespace asperity {

namespace {

using OpenMesh::Vec3d;

struct MeshTraits : OpenMesh::DefaultTraits {
  using Point = Vec3d;
  using Normal = Vec3d;
};
using HalfEdgeMesh = OpenMesh::TriMesh_ArrayKernelT<MeshTraits>;
using Decimater = OpenMesh::Decimater::DecimaterT<HalfEdgeMesh>;
using Quadric = OpenMesh::Geometry::Quadricd;

/// A sample of the given surface and the area that it represents.
struct Sample {
  glm::dvec3 place{};
  double area = 0.0;
};

/// The data of a vertex that persist while the mesh around it changes.
struct VertexPast {
  std::uint32_t origin = 0;       ///< the vertex of the given mesh with these coordinates
  Vec3d normal{0.0};              ///< of the given mesh: of its faces, weighted by angle
  Quadric quadric{};              ///< of the planes that were merged into it
  std::vector<Sample> samples{};  ///< of the given surface around the vertex
};
using PastProperty = OpenMesh::VPropHandleT<VertexPast>;

using CollapseInfo = OpenMesh::Decimater::CollapseInfoT<HalfEdgeMesh>;
using Module = OpenMesh::Decimater::ModBaseT<HalfEdgeMesh>;

constexpr std::size_t kFewestTriangles = 4;  // a tetrahedron

glm::dvec3 place_of(const Vec3d& point) { return {point[0], point[1], point[2]}; }

/// Computes the cost of a collapse.
///
/// Quadrics alone are misleading on rough surfaces: the planes of a fine relief, extended over the length of an edge,
/// deviate more from the surface than a corner that is cut off. The decisive term is therefore the distance of the
/// removed vertex's samples of the given surface from the resulting faces.
class CollapseCost final : public Module {
 public:
  using Handle = OpenMesh::Decimater::ModHandleT<CollapseCost>;

  explicit CollapseCost(HalfEdgeMesh& mesh) : Module(mesh, false) {}

  void set_pasts(PastProperty pasts) { pasts_ = pasts; }
  /// Forbids collapses that move a sample further from the surface than `distance`.
  void set_furthest(double distance) { squared_furthest_ = distance * distance; }

  float collapse_priority(const CollapseInfo& collapse) override {
    constexpr double kQuadricWeight = 0.1;
    constexpr double kEdgeWeight = 1e-6;
    gather_faces(collapse);
    const VertexPast& past = mesh().property(pasts_, collapse.v0);
    double cost = 0.0;
    for (const Sample& sample : past.samples) {
      const double squared = nearest(sample.place).second;
      if (squared > squared_furthest_) return ILLEGAL_COLLAPSE;
      cost += sample.area * squared;
    }
    cost += kQuadricWeight *
            std::max(0.0, past.quadric(collapse.p1) +
                              mesh().property(pasts_, collapse.v1).quadric(collapse.p1));
    const double squared_length = (collapse.p1 - collapse.p0).sqrnorm();
    return static_cast<float>(cost + kEdgeWeight * squared_length * squared_length);
  }

  void preprocess_collapse(const CollapseInfo& collapse) override {
    gather_faces(collapse);
    const VertexPast past = std::move(mesh().property(pasts_, collapse.v0));
    mesh().property(pasts_, collapse.v0) = {};
    mesh().property(pasts_, collapse.v1).quadric += past.quadric;
    for (const Sample& sample : past.samples) keep(sample, keeper_of(sample, collapse));
  }

 private:
  /// A remaining face at its position after the collapse; its first corner is the merged vertex.
  struct Face {
    std::array<HalfEdgeMesh::VertexHandle, 3> corners;
    std::array<glm::dvec3, 3> places{};
  };

  void gather_faces(const CollapseInfo& collapse) {
    faces_.clear();
    for (const auto half : mesh().voh_range(collapse.v0)) {
      const auto face = mesh().face_handle(half);
      if (!face.is_valid() || face == collapse.fl || face == collapse.fr) continue;
      const HalfEdgeMesh::VertexHandle one = mesh().to_vertex_handle(half);
      const HalfEdgeMesh::VertexHandle other =
          mesh().to_vertex_handle(mesh().next_halfedge_handle(half));
      faces_.push_back({.corners = {collapse.v1, one, other},
                        .places = {place_of(collapse.p1), place_of(mesh().point(one)),
                                   place_of(mesh().point(other))}});
    }
  }

  /// The nearest face and its squared distance; null for a vertex without faces.
  std::pair<const Face*, double> nearest(const glm::dvec3& place) const {
    std::pair<const Face*, double> best{nullptr, std::numeric_limits<double>::infinity()};
    for (const Face& face : faces_) {
      const glm::dvec3 b = nearest_in_triangle(face.places, place);
      const glm::dvec3 away =
          b[0] * face.places[0] + b[1] * face.places[1] + b[2] * face.places[2] - place;
      if (const double squared = glm::dot(away, away); squared < best.second) {
        best = {&face, squared};
      }
    }
    return best;
  }

  /// The nearest corner of the nearest face.
  HalfEdgeMesh::VertexHandle keeper_of(const Sample& sample, const CollapseInfo& collapse) const {
    const Face* face = nearest(sample.place).first;
    if (face == nullptr) return collapse.v1;
    std::size_t best = 0;
    for (std::size_t i = 1; i < 3; ++i) {
      if (glm::distance(sample.place, face->places[i]) <
          glm::distance(sample.place, face->places[best])) {
        best = i;
      }
    }
    return face->corners[best];
  }

  void keep(const Sample& sample, HalfEdgeMesh::VertexHandle keeper) {
    constexpr std::size_t kMostSamples = 32;
    std::vector<Sample>& samples = mesh().property(pasts_, keeper).samples;
    samples.push_back(sample);
    if (samples.size() <= kMostSamples) return;
    // Keeps every second sample, with the area of two.
    std::size_t kept = 0;
    for (std::size_t i = 0; i < samples.size(); i += 2) {
      Sample next = samples[i];
      if (i + 1 < samples.size()) next.area += samples[i + 1].area;
      samples[kept++] = next;
    }
    samples.resize(kept);
  }

  PastProperty pasts_{};
  double squared_furthest_ = 0.0;
  std::vector<Face> faces_{};
};

enum class Strictness { turn_and_shape, look, flip_only };

/// Determines which collapses are forbidden.
class NormalControl final : public Module {
 public:
  using Handle = OpenMesh::Decimater::ModHandleT<NormalControl>;

  explicit NormalControl(HalfEdgeMesh& mesh) : Module(mesh, true) {}

  void set_strictness(Strictness strictness) { strictness_ = strictness; }

  void set_pasts(PastProperty pasts) { pasts_ = pasts; }

  float collapse_priority(const CollapseInfo& collapse) override {
    constexpr double kLeastLikeness = 0.1;  // the cosine of 84°
    for (const auto half : mesh().voh_range(collapse.v0)) {
      const auto face = mesh().face_handle(half);
      if (!face.is_valid() || face == collapse.fl || face == collapse.fr) continue;
      const auto one = mesh().to_vertex_handle(half);
      const auto other = mesh().to_vertex_handle(mesh().next_halfedge_handle(half));
      const Corners after{collapse.p1, mesh().point(one), mesh().point(other)};
      if (!allowed({collapse.p0, after[1], after[2]}, after)) return ILLEGAL_COLLAPSE;
      if (strictness_ == Strictness::flip_only) continue;
      // Rotations accumulate over collapses; the normals of the given mesh are constant.
      const Vec3d front = doubled_area(after);
      for (const auto vertex : {HalfEdgeMesh::VertexHandle(collapse.v1), one, other}) {
        const Vec3d& look = mesh().property(pasts_, vertex).normal;
        if ((front | look) <= kLeastLikeness * front.norm() * look.norm()) return ILLEGAL_COLLAPSE;
      }
    }
    return LEGAL_COLLAPSE;
  }

 private:
  using Corners = std::array<Vec3d, 3>;

  static Vec3d doubled_area(const Corners& face) {
    return (face[1] - face[0]) % (face[2] - face[0]);
  }
  /// The roundness of a face: 1 for equal sides, 0 for a degenerate face.
  static double roundness(const Corners& face, double doubled_area) {
    const double sides = (face[1] - face[0]).sqrnorm() + (face[2] - face[1]).sqrnorm() +
                         (face[0] - face[2]).sqrnorm();
    return sides > 0.0 ? 2.0 * std::sqrt(3.0) * doubled_area / sides : 0.0;
  }

  bool allowed(const Corners& before, const Corners& after) const {
    constexpr double kSmallestCosine = 0.5;
    constexpr double kLeastRoundness = 0.05;
    const Vec3d old_area = doubled_area(before);
    const Vec3d new_area = doubled_area(after);
    const double old_size = old_area.norm();
    const double new_size = new_area.norm();
    const double old_roundness = roundness(before, old_size);
    const double new_roundness = roundness(after, new_size);
    if (old_roundness < 1e-6) return true;  // a degenerate face had no orientation
    const double least = strictness_ == Strictness::turn_and_shape ? kSmallestCosine : 0.0;
    if ((old_area | new_area) <= least * old_size * new_size) return false;
    return strictness_ != Strictness::turn_and_shape || new_roundness >= kLeastRoundness ||
           new_roundness >= old_roundness;
  }

  Strictness strictness_ = Strictness::turn_and_shape;
  PastProperty pasts_{};
};

class Watch final : public OpenMesh::Decimater::Observer {
 public:
  Watch(std::size_t collapses, const std::function<void(double)>& progress)
      : Observer(kInterval), collapses_(collapses), progress_(progress) {}
  void notify(std::size_t step) override {
    if (progress_) {
      progress_(
          std::min(1.0, static_cast<double>(before_ + step) / static_cast<double>(collapses_)));
    }
  }
  /// Each simplification counts its steps from one; this sets the offset.
  void begin_after(std::size_t collapses) {
    before_ = collapses;
    notify(0);
  }

 private:
  static constexpr std::size_t kInterval = 1000;
  std::size_t collapses_;
  std::size_t before_ = 0;
  const std::function<void(double)>& progress_;
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
  explicit Simplification(const TriangleMesh& mesh) : place_(place_of(mesh)), mesh_(mesh) {
    for (glm::dvec3& point : mesh_.vertices_m) point = (point - place_.centre_m) / place_.size_m;
    pasts_.resize(mesh_.vertices_m.size());
    for (std::uint32_t i = 0; i < pasts_.size(); ++i) pasts_[i].origin = i;
    for (std::uint32_t i = 0; i < pasts_.size(); ++i) {
      pasts_[i].samples.push_back({.place = mesh_.vertices_m[i]});
    }
    for (const std::array<std::uint32_t, 3>& triangle : mesh_.triangles) remember(triangle);
  }

  std::size_t triangles() const { return mesh_.triangles.size(); }

  /// `furthest` is relative to the size.
  void collapse(std::size_t triangles, Strictness strictness, double furthest, Watch& watch,
                const std::string& name) {
    HalfEdgeMesh half_edges{};
    PastProperty pasts{};
    half_edges.add_property(pasts);
    fill(half_edges, pasts, name);
    Decimater decimater(half_edges);
    CollapseCost::Handle cost{};
    NormalControl::Handle control{};
    decimater.add(cost);
    decimater.add(control);
    decimater.module(cost).set_pasts(pasts);
    decimater.module(cost).set_furthest(furthest);
    decimater.module(control).set_strictness(strictness);
    decimater.module(control).set_pasts(pasts);
    decimater.set_observer(&watch);
    decimater.initialize();
    decimater.decimate_to_faces(0, triangles);
    half_edges.garbage_collection();
    take(half_edges, pasts);
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
  Vec3d point(std::uint32_t vertex) const {
    const glm::dvec3& at = mesh_.vertices_m[vertex];
    return {at.x, at.y, at.z};
  }

  Vec3d doubled_area(const std::array<std::uint32_t, 3>& triangle) const {
    const Vec3d origin = point(triangle[0]);
    return (point(triangle[1]) - origin) % (point(triangle[2]) - origin);
  }

  /// A vertex represents a third of the area of its faces. Its normal is their mean, weighted by angle: weighted by
  /// area, the normal at a corner between a large and a small face would be that of the large one.
  void remember(const std::array<std::uint32_t, 3>& triangle) {
    const Vec3d area = doubled_area(triangle);
    const double size = area.norm();
    if (size <= 0.0) return;
    area_ += 0.5 * size;
    const Vec3d normal = area / size;
    Quadric quadric(normal[0], normal[1], normal[2], -(normal | point(triangle[0])));
    quadric *= 0.5 * size;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3d one = point(triangle[(i + 1) % 3]) - point(triangle[i]);
      const Vec3d other = point(triangle[(i + 2) % 3]) - point(triangle[i]);
      VertexPast& past = pasts_[triangle[i]];
      past.quadric += quadric;
      past.samples.front().area += size / 6.0;
      past.normal += std::atan2((one % other).norm(), one | other) * normal;
    }
  }

  /// Moves the mesh to `half_edges` and leaves this object empty: one copy of millions of faces suffices.
  void fill(HalfEdgeMesh& half_edges, PastProperty pasts, const std::string& name) {
    half_edges.reserve(mesh_.vertices_m.size(), 3 * mesh_.triangles.size() / 2,
                       mesh_.triangles.size());
    for (std::uint32_t i = 0; i < mesh_.vertices_m.size(); ++i) {
      half_edges.property(pasts, half_edges.add_vertex(point(i))) = std::move(pasts_[i]);
    }
    for (const std::array<std::uint32_t, 3>& triangle : mesh_.triangles) {
      const auto corner = [&](std::size_t i) { return half_edges.vertex_handle(triangle[i]); };
      if (!half_edges.add_face(corner(0), corner(1), corner(2)).is_valid()) {
        throw std::invalid_argument(name + " has a non-manifold surface at vertex " +
                                    std::to_string(half_edges.property(pasts, corner(0)).origin) +
                                    " that repair did not detect. Correct the mesh there.");
      }
    }
    mesh_ = {};
    pasts_ = {};
  }

  void take(HalfEdgeMesh& half_edges, PastProperty pasts) {
    for (const auto vertex : half_edges.vertices()) {
      const Vec3d& at = half_edges.point(vertex);
      mesh_.vertices_m.emplace_back(at[0], at[1], at[2]);
      pasts_.push_back(std::move(half_edges.property(pasts, vertex)));
    }
    for (const auto face : half_edges.faces()) {
      std::array<std::uint32_t, 3> triangle{};
      std::size_t next = 0;
      for (const auto vertex : half_edges.fv_range(face)) {
        triangle[next++] = static_cast<std::uint32_t>(vertex.idx());
      }
      mesh_.triangles.push_back(triangle);
    }
  }

  Place place_{};
  TriangleMesh mesh_{};
  std::vector<VertexPast> pasts_{};
  double area_ = 0.0;
};

}  // namespace

SimplifiedMesh decimate_mesh(const TriangleMesh& mesh, std::size_t triangles,
                             const std::string& name, const std::function<void(double)>& progress) {
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
  omerr().disable();  // the error below replaces its output
  Watch watch((mesh.triangles.size() - triangles) / 2, progress);
  Simplification simple(mesh);
  const auto collapse = [&](std::size_t wanted, Strictness strictness, double furthest) {
    if (simple.triangles() <= wanted) return;
    watch.begin_after(
        (mesh.triangles.size() - std::min(mesh.triangles.size(), simple.triangles())) / 2);
    simple.collapse(wanted, strictness, furthest, watch, name);
  };
  constexpr double kFurthest = 1.0;  // no point is as far from a mesh as its size
  const auto collapse_to = [&](std::size_t wanted) {
    for (double furthest = 0.001; furthest < kFurthest; furthest *= 2.0) {
      collapse(wanted, Strictness::turn_and_shape, furthest);
      collapse(wanted, Strictness::look, furthest);
    }
  };
  // A handle can neither close nor open and would occupy an increasing fraction of the remaining faces. It is cut when
  // the surrounding faces are as large as the handle.
  const bool has_handles = handles_of(mesh) > 0;
  for (const std::size_t times : {32U, 16U, 8U, 4U, 2U}) {
    if (!has_handles || simple.triangles() <= times * triangles) continue;
    collapse_to(times * triangles);
    simple.cut_handles(triangles, result);
  }
  collapse_to(triangles);
  collapse(triangles, Strictness::flip_only, kFurthest);
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
