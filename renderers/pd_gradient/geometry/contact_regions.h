// Where two meshes are in each other: pairs of triangles become contacts, each with a direction.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "renderers/pd_gradient/geometry/contact_geometry.h"
#include "renderers/pd_gradient/geometry/mesh_query.h"

namespace asperity {

/// One closed curve, or an open one at a hole, along which two surfaces cut each other.
struct ContactRegion {
  std::uint64_t id = 0;  ///< the same from tick to tick while it is the same contact
  ContactFrame frame{};  ///< in the world; its origin in the middle of the curve
  double width_m = 0.0;  ///< of a square window across n around the origin that holds the curve
  /// Half of the smallest such width, but of kSmallestWidth_m at least; without steps.
  double half_extent_m = 0.0;
  std::size_t pairs = 0;
  /// How upright the faces stand along the curve: n_b·n and −n_a·n, their means by length.
  double upright_a = 1.0;
  double upright_b = 1.0;
};

/// Groups the pairs of intersecting triangles into contacts and gives each its direction n.
///
/// Two triangles cut each other along a segment, and segments of neighbouring pairs join at an edge
/// of one of the meshes. What hangs together is one contact. With lengths Lᵢ [m] of its segments,
/// their middles mᵢ, and the outward normals of their triangles,
///
///   n = Σ Lᵢ (n_bᵢ − n_aᵢ) / |…|      origin = Σ Lᵢ mᵢ / Σ Lᵢ
///
/// so that both move continuously with the bodies: a pair comes and goes with a segment of no length.
/// A region whose normals cancel, so that n would be shorter than 5 % of Σ 2 Lᵢ, has no direction; it
/// is left out and counted.
///
/// A contact is the one of the tick before whose origin is nearest, if nearer than half its window.
/// Its n then follows with a play of `kPlay_rad`: it stays where it is while the new one is nearer
/// than that, and otherwise stays behind by as much. u begins along an axis of B and turns with n about their common normal and
/// about nothing else. The window's width is a power of 2^(1/4) of a millimetre, and shrinks only
/// when two such steps smaller would do, so that the grid does not change with every tick.
///
/// A body that is wholly inside the other cuts no surface and makes no contact.
///
/// Frame and units: SI, the world.
///
/// Real-time: `update` does not allocate, lock or throw, and takes as long as there are pairs, also
/// where all are of one triangle. More than `maximum_regions` regions are
/// counted; those with the longest curves are kept.
class ContactRegions final {
 public:
  static constexpr double kPlay_rad = 0.05;
  static constexpr double kSmallestWidth_m = 1e-3;

  /// Errors: std::invalid_argument for a mesh whose triangles name vertices that there are not.
  ContactRegions(const TriangleMesh& a, const TriangleMesh& b, std::size_t maximum_pairs,
                 std::size_t maximum_regions);

  /// Forgets the tick before.
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
    std::vector<glm::dvec3> normals{};  ///< of the triangles, unit length; 0 for one without area
    // While pairs are joined: of every triangle the last pair with it, of every vertex the last pair
    // of those just looked at.
    std::vector<std::uint32_t> last_of_triangle{};
    std::vector<std::uint32_t> last_of_vertex{};
    explicit Body(const TriangleMesh& mesh);
  };
  /// A body, and which of a pair's triangles is its own.
  struct Side {
    Body* body = nullptr;
    std::uint32_t TrianglePair::*of_pair = nullptr;
  };
  /// What two triangles have in common.
  struct Segment {
    glm::dvec3 ends_m[2]{glm::dvec3(0.0), glm::dvec3(0.0)};
    glm::dvec3 normal_a{0.0};
    glm::dvec3 normal_b{0.0};
    double length_m = 0.0;
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
  void join_neighbours(std::span<const TrianglePair> pairs) noexcept;
  void join_along(std::span<const TrianglePair> pairs, Side same, Side other) noexcept;
  void add_up() noexcept;
  void keep_longest() noexcept;
  const ContactRegion* before(const glm::dvec3& origin_m) noexcept;
  void find_half_extents() noexcept;

  Body a_;
  Body b_;
  std::size_t maximum_regions_ = 0;
  // As long as the pairs of the last update; reserved before.
  std::vector<Segment> segments_{};
  std::vector<std::uint32_t> parents_{};
  std::vector<std::uint32_t> before_it_{};  // the pair before with the same triangle
  std::vector<std::uint32_t> sum_of_root_{};
  std::vector<Sum> sums_{};
  std::vector<ContactRegion> kept_{};
  std::vector<ContactRegion> before_{};
  std::vector<bool> taken_{};
  std::vector<const ContactRegion*> lasts_{};  // of those kept, what they were in the tick before
  std::vector<double> half_extents_m_{};
  std::uint64_t next_id_ = 0;
  std::size_t left_out_ = 0;
};

}  // namespace asperity
