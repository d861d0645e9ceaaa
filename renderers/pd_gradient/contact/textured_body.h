// A textured mesh as a body in contact: what finds it, what is sampled of it, and how fine it is.

#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include <glm/vec3.hpp>

#include "renderers/pd_gradient/geometry/contact_geometry.h"
#include "renderers/pd_gradient/geometry/mesh_query.h"
#include "renderers/pd_gradient/sampling/packed_surface.h"
#include "stimuli/meshes/textured_mesh.h"
#include "stimuli/meshes/triangle_mesh.h"

namespace asperity {

/// A box along the axes of a contact: across n that far from its origin each way, along n likewise.
struct WindowBox {
  double half_width_m = 0.0;
  double half_height_m = 0.0;
};

/// How a line leaves a body.
struct WayOut {
  double way_m = 0.0;      ///< to the first face that looks along the line; `most_m` without one
  bool is_inside = false;  ///< that face is met before any that looks the other way
};

/// Where a point is, as the hull goes.
struct Whereabouts {
  bool is_inside = false;  ///< its winding number is above a half
  /// No face is nearer: of each the larger distance of those to its plane and to a box around it.
  double clear_m = 0.0;
};

/// A mesh with its displacements `gain` times as large, and its hull: the same triangles with every
/// vertex moved outward along its normal by the largest displacement of all faces, margins of the
/// atlas left out: they may go further, by up to an eighth of a grating with ten texels a wave. The
/// textured surface lies inside the hull, so that the hulls of two bodies meet before their textures
/// do. The distance is the same everywhere because a flat side has to stay flat: a hull that
/// followed the texture would cut another one in many places, and each would count as a contact.
///
/// Errors: std::invalid_argument as PackedSurface has them, for a mesh without triangles, and for a
/// gain that is negative or no number.
///
/// Real-time: what is const noexcept does not allocate, lock or throw.
class TexturedBody final {
 public:
  TexturedBody(const TexturedMesh& mesh, double gain);

  const TriangleMesh& hull() const noexcept { return hull_; }
  std::shared_ptr<const ClusteredMesh> hull_clusters() const noexcept { return hull_clusters_; }
  const PackedSurface& surface() const noexcept { return surface_; }
  std::size_t triangles() const noexcept { return hull_.triangles.size(); }
  double furthest_displacement_m() const noexcept { return furthest_m_; }

  /// No less than how thick the hull is: the shortest way between two parallel planes around it, of those
  /// that lie along one of its 256 largest faces. Between two edges a body is thinner, a regular tetrahedron
  /// by 13 %, and the wall of a hollow one by any amount.
  double thickness_m() const noexcept { return thickness_m_; }

  /// How long the finest waves of the texture are (finest_wave.h).
  double finest_wave_m() const noexcept { return finest_wave_m_; }

  /// Fills `room` with the triangles that look along `facing` and touch the box around the frame's
  /// origin, by their plain corners; the frame is in the mesh's own axes, `facing` n or −n. Always in
  /// the same order. Answers how many there are, also when there was no room for all.
  std::size_t find_triangles(const ContactFrame& frame, const glm::dvec3& facing,
                             const WindowBox& box, std::span<std::uint32_t> room) const noexcept;

  /// Where a line from a point along a unit vector first leaves the plain surface, no further away than
  /// `most_m`; in the mesh's own axes.
  WayOut way_out(const glm::dvec3& point_m, const glm::dvec3& along, double most_m) const noexcept;

  /// Visits all faces.
  Whereabouts whereabouts(const glm::dvec3& point_m) const noexcept;

 private:
  PackedSurface surface_;
  TriangleMesh hull_{};
  // Shared with the queries that are made of it.
  std::shared_ptr<const ClusteredMesh> hull_clusters_{};
  ClusteredMesh plain_clusters_;
  double furthest_m_ = 0.0;
  double finest_wave_m_ = 0.0;
  double thickness_m_ = 0.0;
};

}  // namespace asperity
