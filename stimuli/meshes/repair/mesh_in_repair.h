// A mesh between the steps of its repair: triangles, partners of half-edges, and the findings so far.

#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "stimuli/meshes/mesh_edges.h"
#include "stimuli/meshes/mesh_findings.h"
#include "stimuli/meshes/triangle_mesh.h"

namespace asperity::mesh_repair {

using Triangle = std::array<std::uint32_t, 3>;
inline constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// A part is flat if its volume is below this times its area to the power 3/2. A plate a million times as wide as thick
/// has 3.5·10⁻⁷: V = w²·h and A ≈ 2w² give V/A^(3/2) = h/(2^(3/2)·w).
inline constexpr double kFlat = 1e-9;

/// The bounding box of points.
struct Box {
  glm::dvec3 low_m{std::numeric_limits<double>::infinity()};
  glm::dvec3 high_m{-std::numeric_limits<double>::infinity()};
  void add(const glm::dvec3& point_m) {
    low_m = glm::min(low_m, point_m);
    high_m = glm::max(high_m, point_m);
  }
  /// 0 without points.
  double diagonal_m() const { return low_m.x > high_m.x ? 0.0 : glm::length(high_m - low_m); }
};

/// Faces that are connected by vertices.
struct Part {
  Box box{};
  double volume_m3 = 0.0;  ///< negative for a surface that faces inwards; only a closed one has one
  double area_m2 = 0.0;
  std::size_t faces = 0;
  std::uint32_t first_face = 0;
  bool dropped = false;
  bool turned = false;

  bool is_flat() const { return std::abs(volume_m3) < kFlat * std::pow(area_m2, 1.5); }
};

struct Parts {
  std::vector<Part> parts{};
  std::vector<std::uint32_t> of_vertex{};  ///< kNone of a vertex without a face
};

Parts parts_of(const TriangleMesh& mesh);  // parts.cpp

/// Disjoint sets that are joined step by step; each is represented by its smallest member.
class Sets final {
 public:
  explicit Sets(std::size_t size) : parent_(size) {
    std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
  }
  std::uint32_t of(std::uint32_t member) {
    while (parent_[member] != member) {
      parent_[member] = parent_[parent_[member]];
      member = parent_[member];
    }
    return member;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = of(a);
    b = of(b);
    if (a != b) parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

/// The state that the steps change. A half-edge is 3·face + corner: it goes from that corner to the next.
struct MeshInRepair {
  TriangleMesh mesh{};
  MeshRepairLimits limits{};
  std::string name{};
  MeshFindings found{};
  std::vector<std::uint32_t> partner{};              ///< of each half-edge; kNone at a border
  std::vector<std::vector<std::uint32_t>> crowds{};  ///< half-edges of each non-manifold edge

  std::uint32_t from(std::uint32_t half) const { return mesh.triangles[half / 3][half % 3]; }
  std::uint32_t to(std::uint32_t half) const { return from(next_half_edge(half)); }
  std::uint32_t opposite_corner(std::uint32_t half) const {
    return mesh.triangles[half / 3][(half % 3 + 2) % 3];
  }
  /// Throws std::invalid_argument with a sentence that begins with `name`.
  [[noreturn]] void refuse(const std::string& sentence) const;
  [[noreturn]] void refuse_nothing_inside() const;
};

// The steps, in their order. Each is described at its definition; each source file has one subject.

void refuse_not_finite(const MeshInRepair& repair);  // weld.cpp
void weld(MeshInRepair& repair);
void leave_out_bad_faces(MeshInRepair& repair);
void measure(MeshInRepair& repair);

void pair_at_edges(MeshInRepair& repair);  // orientation.cpp
void turn_to_agree(MeshInRepair& repair);
void pair_at_crowded_edges(MeshInRepair& repair);

void split_vertices(MeshInRepair& repair);  // splitting.cpp
void divide_double_edges(MeshInRepair& repair);

void fill_holes(MeshInRepair& repair);  // holes.cpp

void sort_out_parts(MeshInRepair& repair);  // parts.cpp

}  // namespace asperity::mesh_repair
