// One contact of two textured bodies, and its geometrical relations to other contacts.

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include <glm/vec3.hpp>

#include "renderers/pd_gradient/geometry/contact_geometry.h"
#include "renderers/pd_gradient/geometry/contact_regions.h"
#include "renderers/pd_gradient/sampling/penetration.h"

namespace asperity {

/// The largest number of contacts in a tick, also fading ones.
inline constexpr std::size_t kMostContacts = 16;

/// One contact of two textured bodies in a tick.
struct TexturedContact {
  std::uint64_t id = 0;  ///< constant as long as it is the same contact
  /// Constant as long as its force continues, also while it fades; of two that fade as one, the newer. For measurements of
  /// continuity: the model does not read it.
  std::uint64_t force_id = 0;
  ContactFrame frame{};          ///< in the world
  double width_m = 0.0;          ///< of the region
  SamplingGrid grid{};           ///< the sampled window, at least as wide
  Penetration penetration{};     ///< with a depth up to the bound (TexturedContacts)
  double sampled_depth_m = 0.0;  ///< before it was bounded
  double half_extent_m = 0.0;    ///< the larger extent of the curve along u or v, from its middle
  bool is_bounded = false;       ///< the depth exceeded the thickness of the bodies there
  double share =
      1.0;  ///< the rendered fraction of its force; below 1 while contacts separate or merge
  bool is_fading = false;      ///< replaced by another contact; its share falls to 0
  bool is_kept = false;        ///< without a curve; the frame continues from the previous tick
  bool is_coarse = false;      ///< sampled with a longer step than declared
  double filter_m = 0.0;       ///< the way within which slopes may change: the step, or τ
  double half_height_m = 0.0;  ///< of the box in which its triangles are
  double reach_m = 0.0;        ///< the greatest credible depth
  bool is_doubtful = false;    ///< deeper than that: not rendered
  int halvings = 0;            ///< how often its cells may be halved in this tick
  double refine_s = 0.0;       ///< for how long they still may be if it is on one crest from now on
  double leaning_a = 0.0;      ///< the cosines below which faces of A and B sink (sunk_m)
  double leaning_b = 0.0;
  glm::dvec3 origin_in_a_m{0.0};  ///< the origin of the frame in the frame of A
};

inline bool is_felt(const TexturedContact& contact) noexcept {
  return contact.penetration.depth_m > 0.0 && !contact.is_doubtful;
}

/// The contact with this id, not one that fades under it.
std::optional<std::size_t> index_of(std::uint64_t id,
                                    std::span<const TexturedContact> contacts) noexcept;

/// The cosine between two directions up to which contacts count as one: 60°.
inline constexpr double kAgreement = 0.5;
/// The distance up to which two deepest samples are at the same place, in cells: each of two grids has a sample within
/// 0.71 cells, half a diagonal, of a peak.
inline constexpr double kSamePlace = 1.5;

/// Whether a pose is a rotation and a position at which single precision resolves millimetres. Further away, or with
/// another matrix, products overflow and comparisons fail.
bool is_in_reach(const Pose& pose) noexcept;

/// A point (p_BP) or a contact's frame of the world, in the frame of a body. The difference of the positions is rounded before
/// it is rotated, and not after it, as with inverse(X_WB).
glm::dvec3 in_body(const Pose& X_WB, const glm::dvec3& p_WP_m) noexcept;
ContactFrame in_body(const Pose& X_WB, const ContactFrame& frame) noexcept;
/// X_BA, in the same order.
Pose relative(const Pose& X_WA, const Pose& X_WB) noexcept;

/// The deepest sample, in the world.
glm::dvec3 deepest_m(const TexturedContact& contact) noexcept;
/// The force of the whole contact on A, for a stiffness of 1 N/m.
glm::dvec3 force_m(const TexturedContact& contact) noexcept;
/// Whether the deepest sample is outside the square around the contact's curve.
bool is_beside_curve(const TexturedContact& contact) noexcept;

/// Whether the contact at `frame` is already part of the window of another one.
bool is_part_of(const ContactFrame& frame, const TexturedContact& other) noexcept;
/// Whether the whole window of a region is in that of another contact.
bool lies_in(const ContactRegion& region, const TexturedContact& other) noexcept;
/// Whether both contacts have the same deepest place.
bool are_at_one_place(const TexturedContact& one, const TexturedContact& other) noexcept;
/// Whether the deepest place of the first is outside its own curve and inside that of the other.
bool shows_place_of(const TexturedContact& one, const TexturedContact& other) noexcept;

}  // namespace asperity
