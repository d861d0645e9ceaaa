// Half-edges, heap and legality of collapses are OpenMesh's; what a collapse costs and which are forbidden is ours.
//
// OpenMesh's own ModQuadric takes an error for a refusal when rounding makes it negative, which on flat faces is every
// second one; its ModNormalFlipping forbids every collapse beside a face of no area.

#include "stimuli/mesh_decimation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

// QuadricT.hh does not include what it needs.
// clang-format off
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Geometry/QuadricT.hh>
// clang-format on
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModBaseT.hh>
#include <OpenMesh/Tools/Decimater/Observer.hh>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "stimuli/surface_search.h"

namespace asperity {

namespace {

using OpenMesh::Vec3d;

struct MeshTraits : OpenMesh::DefaultTraits {
  using Point = Vec3d;
  using Normal = Vec3d;
};
using HalfEdgeMesh = OpenMesh::TriMesh_ArrayKernelT<MeshTraits>;
using Decimater = OpenMesh::Decimater::DecimaterT<HalfEdgeMesh>;

using CollapseInfo = OpenMesh::Decimater::CollapseInfoT<HalfEdgeMesh>;
using Module = OpenMesh::Decimater::ModBaseT<HalfEdgeMesh>;

constexpr std::size_t kFewestTriangles = 4;  // a tetrahedron

glm::dvec3 place_of(const Vec3d& point) { return {point[0], point[1], point[2]}; }

/// A place of the given surface, and how much of it that place stands for.
struct Sample {
  glm::dvec3 place{};
  double area = 0.0;
};

/// What a vertex remembers of the given surface.
struct Memory {
  OpenMesh::Geometry::Quadricd quadric{};  ///< of the planes that were merged into it
  std::vector<Sample> samples{};           ///< of the surface about it
};
using Memories = OpenMesh::VPropHandleT<Memory>;

/// Each vertex stands for itself, with a third of the area of its faces.
void remember_surface(HalfEdgeMesh& mesh, Memories memories) {
  for (const auto vertex : mesh.vertices()) {
    mesh.property(memories, vertex).samples.push_back({.place = place_of(mesh.point(vertex))});
  }
  for (const auto face : mesh.faces()) {
    std::array<HalfEdgeMesh::VertexHandle, 3> corners;
    std::size_t next = 0;
    for (const auto corner : mesh.fv_range(face)) corners[next++] = corner;
    const Vec3d origin = mesh.point(corners[0]);
    Vec3d normal = (mesh.point(corners[1]) - origin) % (mesh.point(corners[2]) - origin);
    const double doubled_area = normal.norm();
    if (doubled_area <= 0.0) continue;
    normal /= doubled_area;
    OpenMesh::Geometry::Quadricd quadric(normal[0], normal[1], normal[2], -(normal | origin));
    quadric *= 0.5 * doubled_area;
    for (const auto corner : corners) {
      mesh.property(memories, corner).quadric += quadric;
      mesh.property(memories, corner).samples.front().area += doubled_area / 6.0;
    }
  }
}

/// What a collapse costs.
///
/// Planes alone would mislead on rough surfaces: extended over the length of an edge, those of a fine relief are
/// further from the surface than a corner that is cut off. What decides is how far the samples of the given
/// surface that the vanishing vertex keeps are from the faces that come of it.
class CollapseCost final : public Module {
 public:
  using Handle = OpenMesh::Decimater::ModHandleT<CollapseCost>;

  explicit CollapseCost(HalfEdgeMesh& mesh) : Module(mesh, false) {}

  void set_memories(Memories memories) { memories_ = memories; }
  /// A collapse that takes a sample further from the surface is not done.
  void set_furthest(double distance) { squared_furthest_ = distance * distance; }

  float collapse_priority(const CollapseInfo& collapse) override {
    constexpr double kQuadricWeight = 0.1;
    constexpr double kEdgeWeight = 1e-6;
    gather_faces(collapse);
    const Memory& memory = mesh().property(memories_, collapse.v0);
    double cost = 0.0;
    for (const Sample& sample : memory.samples) {
      const double squared = nearest(sample.place).second;
      if (squared > squared_furthest_) return ILLEGAL_COLLAPSE;
      cost += sample.area * squared;
    }
    cost += kQuadricWeight *
            std::max(0.0, memory.quadric(collapse.p1) +
                              mesh().property(memories_, collapse.v1).quadric(collapse.p1));
    const double squared_length = (collapse.p1 - collapse.p0).sqrnorm();
    return static_cast<float>(cost + kEdgeWeight * squared_length * squared_length);
  }

  void preprocess_collapse(const CollapseInfo& collapse) override {
    gather_faces(collapse);
    const Memory memory = std::move(mesh().property(memories_, collapse.v0));
    mesh().property(memories_, collapse.v0) = {};
    mesh().property(memories_, collapse.v1).quadric += memory.quadric;
    for (const Sample& sample : memory.samples) keep(sample, keeper_of(sample, collapse));
  }

 private:
  /// A face that stays, moved to where it will be: its first corner is the vertex that both become.
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

  /// With the squared distance; of a vertex without faces, none.
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
    std::vector<Sample>& samples = mesh().property(memories_, keeper).samples;
    samples.push_back(sample);
    if (samples.size() <= kMostSamples) return;
    // Every second one, which then stands for two.
    std::size_t kept = 0;
    for (std::size_t i = 0; i < samples.size(); i += 2) {
      Sample next = samples[i];
      if (i + 1 < samples.size()) next.area += samples[i + 1].area;
      samples[kept++] = next;
    }
    samples.resize(kept);
  }

  Memories memories_{};
  double squared_furthest_ = 0.0;
  std::vector<Face> faces_{};
};

enum class Strictness { turn_and_shape, look, flip_only };

/// Which collapses are forbidden.
class NormalControl final : public Module {
 public:
  using Handle = OpenMesh::Decimater::ModHandleT<NormalControl>;

  explicit NormalControl(HalfEdgeMesh& mesh) : Module(mesh, true) {}

  void set_strictness(Strictness strictness) { strictness_ = strictness; }

  /// Of the mesh that it begins with; vertices keep theirs to the end.
  void set_normals(OpenMesh::VPropHandleT<Vec3d> normals) { normals_ = normals; }

  float collapse_priority(const CollapseInfo& collapse) override {
    for (const auto half : mesh().voh_range(collapse.v0)) {
      const auto face = mesh().face_handle(half);
      if (!face.is_valid() || face == collapse.fl || face == collapse.fr) continue;
      const auto one = mesh().to_vertex_handle(half);
      const auto other = mesh().to_vertex_handle(mesh().next_halfedge_handle(half));
      const Corners after{collapse.p1, mesh().point(one), mesh().point(other)};
      if (!allowed({collapse.p0, after[1], after[2]}, after)) return ILLEGAL_COLLAPSE;
      if (strictness_ == Strictness::flip_only) continue;
      // Turns add up, collapse by collapse; what a vertex once looked like does not change.
      const Vec3d front = doubled_area(after);
      for (const auto vertex : {HalfEdgeMesh::VertexHandle(collapse.v1), one, other}) {
        if ((front | mesh().property(normals_, vertex)) <= 0.0) return ILLEGAL_COLLAPSE;
      }
    }
    return LEGAL_COLLAPSE;
  }

 private:
  using Corners = std::array<Vec3d, 3>;

  static Vec3d doubled_area(const Corners& face) {
    return (face[1] - face[0]) % (face[2] - face[0]);
  }
  /// 1 for equal sides, 0 for a needle.
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
    if (old_roundness < 1e-6) return true;  // it had no direction that could turn
    const double least = strictness_ == Strictness::turn_and_shape ? kSmallestCosine : 0.0;
    if ((old_area | new_area) <= least * old_size * new_size) return false;
    return strictness_ != Strictness::turn_and_shape || new_roundness >= kLeastRoundness ||
           new_roundness >= old_roundness;
  }

  Strictness strictness_ = Strictness::turn_and_shape;
  OpenMesh::VPropHandleT<Vec3d> normals_{};
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
  /// Steps are counted from one each time.
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

/// Where a mesh lies, so that the arithmetic can happen about the origin at a size of one.
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

}  // namespace

TriangleMesh decimate_mesh(const TriangleMesh& mesh, std::size_t triangles, const std::string& name,
                           const std::function<void(double)>& progress) {
  if (triangles < kFewestTriangles) {
    throw std::invalid_argument(name + " cannot have " + std::to_string(triangles) +
                                " triangles; a closed mesh has at least 4.");
  }
  if (triangles > mesh.triangles.size()) {
    throw std::invalid_argument(name + " cannot be simplified to " + std::to_string(triangles) +
                                " triangles: it has only " + std::to_string(mesh.triangles.size()) +
                                '.');
  }
  if (triangles == mesh.triangles.size()) return mesh;
  omerr().disable();  // what it would print is said below, in a sentence
  const Place place = place_of(mesh);
  HalfEdgeMesh half_edges{};
  half_edges.reserve(mesh.vertices_m.size(), 3 * mesh.triangles.size() / 2, mesh.triangles.size());
  // Which vertex of `mesh` it is: the result has its very coordinates.
  OpenMesh::VPropHandleT<std::uint32_t> origin{};
  half_edges.add_property(origin);
  for (std::uint32_t i = 0; i < mesh.vertices_m.size(); ++i) {
    const glm::dvec3 point = (mesh.vertices_m[i] - place.centre_m) / place.size_m;
    half_edges.property(origin, half_edges.add_vertex(Vec3d(point.x, point.y, point.z))) = i;
  }
  for (const std::array<std::uint32_t, 3>& triangle : mesh.triangles) {
    const auto corner = [&](std::size_t i) { return half_edges.vertex_handle(triangle[i]); };
    if (!half_edges.add_face(corner(0), corner(1), corner(2)).is_valid()) {
      throw std::invalid_argument(name +
                                  " has a surface that no half-edges can follow, at vertex " +
                                  std::to_string(triangle[0]) + "; its repair has not seen it.");
    }
  }
  OpenMesh::VPropHandleT<Vec3d> normals{};
  half_edges.add_property(normals);
  for (const auto vertex : half_edges.vertices()) half_edges.property(normals, vertex) = Vec3d(0.0);
  for (const auto face : half_edges.faces()) {
    // By angle: by area, a corner between a large face and a small one would look like the large one alone.
    const Vec3d front = half_edges.calc_face_normal(face);
    for (const auto half : half_edges.fh_range(face)) {
      half_edges.property(normals, half_edges.to_vertex_handle(half)) +=
          half_edges.calc_sector_angle(half) * front;
    }
  }
  Watch watch((mesh.triangles.size() - triangles) / 2, progress);
  Memories memories{};
  half_edges.add_property(memories);
  remember_surface(half_edges, memories);
  const auto collapse_all = [&](Strictness strictness, double furthest) {
    if (half_edges.n_faces() <= triangles) return;
    Decimater decimater(half_edges);
    CollapseCost::Handle cost{};
    NormalControl::Handle control{};
    decimater.add(cost);
    decimater.add(control);
    decimater.module(cost).set_memories(memories);
    decimater.module(cost).set_furthest(furthest);
    decimater.module(control).set_strictness(strictness);
    decimater.module(control).set_normals(normals);
    decimater.set_observer(&watch);
    watch.begin_after((mesh.triangles.size() - half_edges.n_faces()) / 2);
    decimater.initialize();
    decimater.decimate_to_faces(0, triangles);
    half_edges.garbage_collection();
  };
  constexpr double kFurthest = 1.0;  // nothing is as far from a mesh as it is long
  for (double furthest = 0.001; furthest < kFurthest; furthest *= 2.0) {
    collapse_all(Strictness::turn_and_shape, furthest);
    collapse_all(Strictness::look, furthest);
  }
  collapse_all(Strictness::flip_only, kFurthest);
  if (half_edges.n_faces() > triangles) {
    throw std::invalid_argument(
        name + " cannot be simplified to " + std::to_string(triangles) + " triangles: at " +
        std::to_string(half_edges.n_faces()) +
        " no edge can go any more without a face turning over or a part or handle closing up.");
  }
  TriangleMesh result{};
  for (const auto vertex : half_edges.vertices()) {
    result.vertices_m.push_back(mesh.vertices_m[half_edges.property(origin, vertex)]);
  }
  for (const auto face : half_edges.faces()) {
    std::array<std::uint32_t, 3> triangle{};
    std::size_t next = 0;
    for (const auto vertex : half_edges.fv_range(face)) {
      triangle[next++] = static_cast<std::uint32_t>(vertex.idx());
    }
    result.triangles.push_back(triangle);
  }
  return result;
}

}  // namespace asperity
