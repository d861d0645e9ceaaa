// Declares the memory layout of a mesh for the search for intersecting triangles.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "renderers/pd_gradient/geometry/contact_geometry.h"
#include "renderers/pd_gradient/loops/triangle_loops.h"
#include "stimuli/meshes/triangle_mesh.h"

namespace asperity {

/// The rounding error of a position in single precision relative to the radius of a mesh, with a margin for the products of the
/// test.
inline constexpr float kRoundingOfRadius = 4e-6F;

/// Stores the triangles of one mesh in clusters of sixteen for the query.
class ClusteredMesh final {
 public:
  /// Errors: std::invalid_argument for a mesh without triangles or with a corner that is not a vertex.
  explicit ClusteredMesh(const TriangleMesh& mesh);

  const glm::dvec3& centre_m() const noexcept { return centre_m_; }
  double radius_m() const noexcept { return radius_m_; }  ///< of a sphere around the centre
  std::span<const TriangleCluster> clusters() const noexcept { return clusters_; }
  std::span<const ClusterBoxes> boxes() const noexcept { return boxes_; }
  /// The corners of a triangle as in the clusters: [corner][axis], from the centre.
  using CornersFromCentre = std::array<std::array<float, 3>, 3>;
  const CornersFromCentre& corners_from_centre_m(std::uint32_t triangle) const noexcept {
    return corners_from_centre_m_[triangle];
  }
  /// A box with three perpendicular unit vectors and its half-size along each, and a direction.
  struct Box {
    glm::dvec3 centre_m{0.0};
    std::array<glm::dvec3, 3> axes{};
    std::array<double, 3> half_m{};
    glm::dvec3 facing{0.0};
  };
  /// The same from the centre of the mesh, in single precision.
  SlabBox slab_box(const Box& box) const noexcept;
  /// The triangles of a cluster, as bits, that face the direction and touch the box or are within the rounding error of touching it.
  std::uint32_t find_in_box(std::size_t cluster, const SlabBox& box) const noexcept;
  /// A triangle's corners, as in the mesh.
  const std::array<glm::dvec3, 3>& corners_m(std::uint32_t triangle) const noexcept {
    return corners_m_[triangle];
  }
  std::size_t bytes() const noexcept;

 private:
  glm::dvec3 centre_m_{0.0};
  double radius_m_ = 0.0;
  const TriangleLoops* loops_ = nullptr;
  std::vector<TriangleCluster> clusters_{};
  std::vector<ClusterBoxes> boxes_{};
  std::vector<std::array<glm::dvec3, 3>> corners_m_{};
  std::vector<CornersFromCentre> corners_from_centre_m_{};
};

/// The transformation of `find_candidates` and `judge_pairs`, with the rounding error of positions as the tolerance.
ClusterPose cluster_pose(const ClusteredMesh& a, const ClusteredMesh& b, const Pose& X_BA) noexcept;

}  // namespace asperity
