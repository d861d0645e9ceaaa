// The turn from one orientation to the next, as a vector.

#include "device/small_turn.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace asperity {

glm::dvec3 small_turn_rad(const glm::dquat& from, const glm::dquat& to) noexcept {
  glm::dquat turn = to * glm::conjugate(from);
  if (turn.w < 0.0) turn = -turn;  // q and −q are one orientation
  const glm::dvec3 axis(turn.x, turn.y, turn.z);
  const double sine = glm::length(axis);
  // angle/sin(angle/2) tends to 2.
  const double factor = sine < 1e-12 ? 2.0 : 2.0 * std::atan2(sine, turn.w) / sine;
  return factor * axis;
}

}  // namespace asperity
