// Declares the contact regions of two intersecting meshes: groups of triangle pairs, each with a direction.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "renderers/pd_gradient/geometry/contact_geometry.h"
#include "renderers/pd_gradient/geometry/mesh_query.h"
#include "renderers/pd_gradient/loops/instruction_set.h"
#include "renderers/pd_gradient/loops/triangle_loops.h"

namespace asperity {

/// One closed curve, or an open one at a hole, along which two surfaces intersect.
struct ContactRegion {
  std::uint64_t id = 0;  ///< the same from tick to tick during a contact
  ContactFrame frame{};  ///< in the world; its origin is the middle of the curve
  double width_m = 0.0;  ///< of a square window around the origin, across n, with the whole curve
  /// Half of the smallest such width, at least kSmallestWidth_m; not rounded to steps.
  double half_extent_m = 0.0;
  std::size_t pairs = 0;
  /// The inclination of the faces along the curve: n_b·n and −n_a·n, as means weighted by length.
  double upright_a = 1.0;
  double upright_b = 1.0;
};

/// Groups the pairs of intersecting triangles into contacts and determines the direction n of each.
///
/// Two triangles intersect along a segment, and segments of neighbouring pairs join at an edge of one of the meshes. A
/// connected group is one contact. With the lengths Lᵢ [m] of its segments, their midpoints mᵢ, and the outward normals
/// of their triangles,
///
///   n = Σ Lᵢ (n_bᵢ − n_aᵢ) / |…|      origin = Σ Lᵢ mᵢ / Σ Lᵢ
///
/// Both are continuous in the motion of the bodies: a pair appears and disappears with a segment of length zero. A
/// region whose normals cancel, so that n would be shorter than 5 % of Σ 2 Lᵢ, has no direction; it is left out and
/// counted.
///
/// A contact is identified with that of the previous tick whose origin is nearest, if nearer than half its window. Its
/// n then follows with a play of `kPlay_rad`: it is constant while the new direction is within the play, and otherwise
/// lags by the play. u initially lies along an axis of B and then rotates with n only, about the common normal of old
/// and new n. The window's width is a power of 2^(1/4) of a millimetre, and it decreases only if a width two such steps
/// smaller is sufficient, so that the grid does not change in every tick.
///
/// A body that is completely inside the other intersects no surface and makes no contact.
///
/// Frame and units: SI, the world.
///
/// Real-time: `update` does not allocate, lock or throw; its time is proportional to the number of pairs, even if all
/// have one triangle in common. Regions beyond `maximum_regions` are counted; those with the longest curves are kept.
class ContactRegions final {
 public:
  static constexpr double kPlay_rad = 0.05;
  static constexpr double kSmallestWidth_m = 1e-3;

  /// Errors: std::invalid_argument for a mesh whose triangles refer to missing vertices.
  ContactRegions(const TriangleMesh& a, const TriangleMesh& b, std::size_t maximum_pairs,
                 std::size_t maximum_regions, InstructionSet set = instruction_sets_here().back());

  /// Clears the previous tick.
  void reset() noexcept {
    kept_.clear();
    next_id_ = 0;
  }

  /// The regions of these pairs, longest first; valid until the next call.
  std::span<const ContactRegion> update(std::span<const TrianglePair> pairs, const Pose& a,
                                        const Pose& b) noexcept;

  std::size_t regions_left_out() const noexcept { return left_out_; }  ///< in the last update

 private:
  struct Body {
    std::vector<glm::dvec3> vertices_m{};
    std::vector<std::array<std::uint32_t, 3>> triangles{};
    std::vector<glm::dvec3> normals{};  ///< of the triangles, unit length; 0 for zero area
    // During the joining: for every triangle its last pair, for every vertex the last pair of the current list.
    std::vector<std::uint32_t> last_of_triangle{};
    std::vector<std::uint32_t> last_of_vertex{};
    explicit Body(const TriangleMesh& mesh);
    void put(std::uint32_t triangle, SegmentTriangles& batch, std::size_t lane) const noexcept;
  };
  /// A body, and its triangle in a pair.
  struct Side {
    Body* body = nullptr;
    std::uint32_t TrianglePair::*of_pair = nullptr;
  };
  struct Sum {
    double length_m = 0.0;
    glm::dvec3 middles{0.0};    ///< Σ Lᵢ mᵢ
    glm::dvec3 normals_a{0.0};  ///< Σ Lᵢ n_a
    glm::dvec3 normals_b{0.0};
    std::size_t pairs = 0;
    std::uint32_t root = 0;
  };

  std::uint32_t root_of(std::uint32_t pair) noexcept;
  void join(std::uint32_t one, std::uint32_t other) noexcept;
  void set_pairs(std::span<const TrianglePair> pairs) noexcept;
  void join_neighbours(std::span<const TrianglePair> pairs) noexcept;
  void join_along(std::span<const TrianglePair> pairs, Side same, Side other) noexcept;
  void add_up() noexcept;
  void keep_longest() noexcept;
  const ContactRegion* before(const glm::dvec3& origin_m) noexcept;
  void find_half_extents() noexcept;

  const TriangleLoops* loops_ = nullptr;
  Body a_;
  Body b_;
  std::size_t maximum_pairs_ = 0;
  std::size_t maximum_regions_ = 0;
  // Of the pairs, eight at a time.
  std::vector<SegmentTriangles> triangles_a_{};
  std::vector<SegmentTriangles> triangles_b_{};
  std::vector<Segments> segments_{};
  // As long as the pairs of the last update; the memory is reserved in advance.
  std::vector<std::uint32_t> parents_{};
  std::vector<TrianglePair>
      joined_{};  // the pairs of parents_; often the same as in the previous tick
  std::vector<std::uint32_t> before_it_{};  // the previous pair with the same triangle
  std::vector<std::uint32_t> sum_of_root_{};
  std::vector<Sum> sums_{};
  std::vector<ContactRegion> kept_{};
  std::vector<ContactRegion> before_{};
  std::vector<bool> taken_{};
  std::vector<const ContactRegion*> lasts_{};  // the kept regions' states in the previous tick
  std::vector<double> half_extents_m_{};
  std::uint64_t next_id_ = 0;
  std::size_t left_out_ = 0;
};

}  // namespace asperity
