// Which triangles of two meshes intersect.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "renderers/pd_gradient/geometry/contact_geometry.h"
#include "renderers/pd_gradient/loops/instruction_set.h"
#include "renderers/pd_gradient/loops/triangle_loops.h"
#include "stimuli/meshes/triangle_mesh.h"

namespace asperity {

/// A triangle of A and a triangle of B, by their indices.
struct TrianglePair {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  friend bool operator==(const TrianglePair&, const TrianglePair&) = default;
};

/// The triangles of one mesh in clusters of sixteen, as the query reads them.
class ClusteredMesh final {
 public:
  /// Errors: std::invalid_argument for a mesh without triangles or with a corner that is no vertex.
  explicit ClusteredMesh(const TriangleMesh& mesh);

  const glm::dvec3& centre_m() const noexcept { return centre_m_; }
  double radius_m() const noexcept { return radius_m_; }  ///< of a ball around the centre
  std::span<const TriangleCluster> clusters() const noexcept { return clusters_; }
  std::span<const ClusterBoxes> boxes() const noexcept { return boxes_; }
  /// A triangle's corners, as the mesh has them.
  const std::array<glm::dvec3, 3>& corners_m(std::uint32_t triangle) const noexcept {
    return corners_m_[triangle];
  }

 private:
  glm::dvec3 centre_m_{0.0};
  double radius_m_ = 0.0;
  std::vector<TriangleCluster> clusters_{};
  std::vector<ClusterBoxes> boxes_{};
  std::vector<std::array<glm::dvec3, 3>> corners_m_{};
};

/// Finds every pair of triangles, one of each mesh, that share a point.
///
/// Two triangles are apart if and only if a plane is between them whose normal is one of seventeen:
/// the two of the triangles, the nine products of their edges, and the six in their planes across
/// an edge. The test runs in single precision on sixteen triangles at once; what it finds nearer to
/// touching than its rounding is decided in double precision. Triangles that touch are a pair.
///
/// The same pairs in the same order whatever the processor: the code is compiled for SSE2, AVX2 and
/// AVX-512 without contraction, and the widest that the processor has is used.
///
/// Real-time: `find` does not allocate, lock or throw.
///
/// Sources: separating axes [Gottschalk 1996].
class MeshQuery final {
 public:
  /// More pairs than `maximum_pairs` are counted, not listed.
  MeshQuery(std::shared_ptr<const ClusteredMesh> a, std::shared_ptr<const ClusteredMesh> b,
            std::size_t maximum_pairs);
  /// With the code for one instruction set, which has to be among `instruction_sets_here()`.
  MeshQuery(std::shared_ptr<const ClusteredMesh> a, std::shared_ptr<const ClusteredMesh> b,
            std::size_t maximum_pairs, InstructionSet set);

  /// Ordered by cluster; valid until the next call.
  std::span<const TrianglePair> find(const Pose& a_in_b) noexcept;
  /// Of the last `find`, all that intersect.
  std::size_t count() const noexcept { return count_; }

  const ClusteredMesh& a() const noexcept { return *a_; }
  const ClusteredMesh& b() const noexcept { return *b_; }

 private:
  // Shared, because every stimulus with the same tool or surface has a query of its own.
  std::shared_ptr<const ClusteredMesh> a_{};
  std::shared_ptr<const ClusteredMesh> b_{};
  const TriangleLoops* loops_ = nullptr;
  std::vector<TrianglePair> pairs_{};
  std::size_t count_ = 0;
};

/// Whether two triangles share a point, in double precision: what `MeshQuery` goes back to.
bool triangles_intersect(const std::array<glm::dvec3, 3>& a,
                         const std::array<glm::dvec3, 3>& b) noexcept;

}  // namespace asperity
