// Compares contacts by place, direction and region, with limits relative to their width.

#include "renderers/pd_gradient/contact/textured_contact.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace asperity {
namespace {

// Whether both are rendered, along about the same direction.
bool are_felt_alike(const TexturedContact& one, const TexturedContact& other) noexcept {
  return is_felt(one) && is_felt(other) && glm::dot(one.frame.n, other.frame.n) >= kAgreement;
}

// The larger distance across n.
double aside_m(const glm::dvec3& way_m) noexcept {
  return std::max(std::abs(way_m.x), std::abs(way_m.y));
}

}  // namespace

std::optional<std::size_t> index_of(std::uint64_t id,
                                    std::span<const TexturedContact> contacts) noexcept {
  const auto found = std::find_if(contacts.begin(), contacts.end(), [id](const auto& contact) {
    return contact.id == id && !contact.is_fading;
  });
  if (found == contacts.end()) return std::nullopt;
  return static_cast<std::size_t>(found - contacts.begin());
}

bool is_in_reach(const Pose& pose) noexcept {
  constexpr double kFurthest_m = 1e4;
  constexpr double kUnit = 1e-3;
  for (int axis = 0; axis < 3; ++axis) {
    const glm::dvec3& column = pose.rotation[axis];
    if (!(std::abs(glm::dot(column, column) - 1.0) <= kUnit)) return false;  // false for NaN
    if (!(std::abs(pose.position_m[axis]) <= kFurthest_m)) return false;
  }
  return true;
}

glm::dvec3 in_body(const Pose& X_WB, const glm::dvec3& p_WP_m) noexcept {
  return glm::transpose(X_WB.rotation) * (p_WP_m - X_WB.position_m);
}

Pose relative(const Pose& X_WA, const Pose& X_WB) noexcept {
  const glm::dmat3 back = glm::transpose(X_WB.rotation);
  return {.rotation = back * X_WA.rotation,
          .position_m = back * (X_WA.position_m - X_WB.position_m)};
}

ContactFrame in_body(const Pose& X_WB, const ContactFrame& frame) noexcept {
  const glm::dmat3 back = glm::transpose(X_WB.rotation);
  return {.origin_m = in_body(X_WB, frame.origin_m),
          .u = back * frame.u,
          .v = back * frame.v,
          .n = back * frame.n};
}

bool is_part_of(const ContactFrame& frame, const TexturedContact& other) noexcept {
  if (glm::dot(frame.n, other.frame.n) < kAgreement) return false;
  const glm::dvec3 way_m = other.frame.to_frame(frame.origin_m - other.frame.origin_m);
  const double half_m = 0.5 * other.grid.width_m;
  return std::abs(way_m.x) <= half_m && std::abs(way_m.y) <= half_m &&
         std::abs(way_m.z) <= other.half_height_m;
}

glm::dvec3 deepest_m(const TexturedContact& contact) noexcept {
  return contact.frame.origin_m + contact.frame.to_world(contact.penetration.deepest_m);
}

bool are_at_one_place(const TexturedContact& one, const TexturedContact& other) noexcept {
  const double cell_m = std::max(one.grid.spacing_m(), other.grid.spacing_m());
  return are_felt_alike(one, other) &&
         glm::distance(deepest_m(one), deepest_m(other)) <= kSamePlace * cell_m;
}

glm::dvec3 force_m(const TexturedContact& contact) noexcept {
  return contact_wrench(contact.penetration, contact.frame, 1.0).force_N;
}

bool is_beside_curve(const TexturedContact& contact) noexcept {
  return aside_m(contact.penetration.deepest_m) >
         contact.half_extent_m + kSamePlace * contact.grid.spacing_m();
}

bool shows_place_of(const TexturedContact& one, const TexturedContact& other) noexcept {
  if (!is_beside_curve(one) || !are_felt_alike(one, other)) return false;
  const glm::dvec3 way_m = other.frame.to_frame(deepest_m(one) - other.frame.origin_m);
  return aside_m(way_m) <= other.half_extent_m && std::abs(way_m.z) <= other.half_height_m;
}

bool lies_in(const ContactRegion& region, const TexturedContact& other) noexcept {
  const glm::dvec3 way_m = other.frame.to_frame(region.frame.origin_m - other.frame.origin_m);
  const double room_m = 0.5 * (other.grid.width_m - region.width_m);
  return is_part_of(region.frame, other) && std::abs(way_m.x) <= room_m &&
         std::abs(way_m.y) <= room_m;
}

}  // namespace asperity
