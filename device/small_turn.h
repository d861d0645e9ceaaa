// The turn from one orientation to the next, as a vector.

#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

namespace asperity {

/// The rotation vector, axis times angle, that takes `from` to `to`, about the axes of the room; the
/// shorter way round. Divided by the time between, it is the mean angular velocity. (0, 0, 0) for equal ones.
///
/// Real-time: does not allocate, lock or throw.
glm::dvec3 small_turn_rad(const glm::dquat& from, const glm::dquat& to) noexcept;

}  // namespace asperity
