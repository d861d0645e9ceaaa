// Declares the motion of two bodies from one tick to the next.

#pragma once

#include <glm/vec3.hpp>

#include "renderers/pd_gradient/contact/textured_contact.h"

namespace asperity {

/// The poses of A and B in this tick and in the previous one.
struct BodyMotion {
  Pose X_WA{};
  Pose X_WB{};
  Pose X_WA_before{};
  Pose X_WB_before{};

  /// How far A has moved at a place of the world since the previous tick, relative to B.
  glm::dvec3 way_m(const glm::dvec3& now_m) const noexcept;
  /// Where a place of A is now that was there in the previous tick.
  glm::dvec3 now_on_a_m(const glm::dvec3& before_m) const noexcept;
  /// The frame of a contact of the previous tick in the present poses: n moves with B, the origin with A.
  ContactFrame continued(const TexturedContact& last) const noexcept;
};

}  // namespace asperity
