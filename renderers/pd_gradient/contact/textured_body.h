// Declares a textured mesh as a body in contact: its hull, its sampled surface and the finest waves of its texture.

#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include <glm/vec3.hpp>

#include "renderers/pd_gradient/geometry/contact_geometry.h"
#include "renderers/pd_gradient/geometry/finest_wave.h"
#include "renderers/pd_gradient/geometry/mesh_query.h"
#include "renderers/pd_gradient/sampling/packed_surface.h"
#include "stimuli/meshes/textured_mesh.h"
#include "stimuli/meshes/triangle_mesh.h"

namespace asperity {

/// A box in the axes of a contact: half-sizes perpendicular to n and along n, about the frame's origin.
struct WindowBox {
  double half_width_m = 0.0;
  double half_height_m = 0.0;
};

/// The intersection of a ray with the surface of a body, from inside outwards.
struct WayOut {
  double way_m = 0.0;      ///< to the first face that the ray leaves through; `most_m` if none
  bool is_inside = false;  ///< this face comes before any that the ray enters through
};

/// The position of a point relative to the hull.
struct Whereabouts {
  bool is_inside = false;  ///< its winding number is above one half
  /// Radius without faces: the minimum over the faces of the larger of the distances to its plane and to its bounding
  /// box.
  double clear_m = 0.0;
};

/// Stores a mesh with its displacements multiplied by `gain`, and its hull: the same triangles with every vertex moved
/// outward along its normal by the largest displacement of all faces. Margins of the atlas are excluded; they may go
/// further, by up to an eighth of a grating with ten texels per wave. The textured surface lies inside the hull, so
/// that the hulls of two bodies touch before their textures do. The distance is the same everywhere because a flat side
/// has to remain flat: a hull that followed the texture would intersect another one in many places, and each would
/// count as a contact.
///
/// With a gain of 0 it has no texels, and the forces of the plain mesh.
///
/// Copies share their memory: making one takes no time, and each may be used by another thread.
///
/// Errors: std::invalid_argument in the cases of PackedSurface, for a mesh without triangles, and for a gain that is
/// negative or not a number.
///
/// Real-time: const noexcept functions do not allocate, lock or throw.
class TexturedBody final {
 public:
  TexturedBody(const TexturedMesh& textured, double gain);

  const TriangleMesh& hull() const noexcept { return *hull_; }
  std::shared_ptr<const ClusteredMesh> hull_clusters() const noexcept { return hull_clusters_; }
  const PackedSurface& surface() const noexcept { return *surface_; }
  std::size_t triangles() const noexcept { return hull_->triangles.size(); }
  /// Of the memory that copies share.
  std::size_t bytes() const noexcept;
  double furthest_displacement_m() const noexcept { return furthest_m_; }

  /// An upper bound of the thickness of the hull: the smallest distance between two parallel planes that enclose it,
  /// among those parallel to one of its 256 largest faces. Between two edges a body can be thinner, a regular
  /// tetrahedron by 13 %, and the wall of a hollow body by any amount.
  double thickness_m() const noexcept { return thickness_m_; }

  /// The wavelength of the finest waves of the texture (finest_wave.h).
  double finest_wave_m() const noexcept { return waves_.finest_m; }

  /// The curvature of the crests of the texture (FineWaves).
  double crest_per_m() const noexcept { return waves_.crest_per_m; }

  /// Fills `room` with the triangles that face `facing` and touch the box around the frame's origin or are within the rounding
  /// error of single precision of touching it, by their undisplaced corners, always in the same order. The frame is in the mesh's own axes; `facing` is n or −n. Returns
  /// the number of triangles found, which may exceed the room.
  std::size_t find_triangles(const ContactFrame& frame, const glm::dvec3& facing,
                             const WindowBox& box, std::span<std::uint32_t> room) const noexcept;

  /// The first point, within `most_m`, where a ray from a point along a unit vector leaves the undisplaced surface; in
  /// the mesh's own axes.
  WayOut way_out(const glm::dvec3& point_m, const glm::dvec3& along, double most_m) const noexcept;

  /// The position of a point relative to the hull. Visits all faces.
  Whereabouts whereabouts(const glm::dvec3& point_m) const noexcept;

 private:
  std::shared_ptr<const PackedSurface> surface_{};
  std::shared_ptr<const TriangleMesh> hull_{};
  // Shared with the queries that use it.
  std::shared_ptr<const ClusteredMesh> hull_clusters_{};
  std::shared_ptr<const ClusteredMesh> plain_clusters_{};
  double furthest_m_ = 0.0;
  FineWaves waves_{};
  double thickness_m_ = 0.0;
};

}  // namespace asperity
