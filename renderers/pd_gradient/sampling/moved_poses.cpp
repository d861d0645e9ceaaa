// Moves and turns A by each step in both directions, and divides the differences of the depths.

#include "renderers/pd_gradient/sampling/moved_poses.h"

#include <algorithm>

#include <glm/gtc/quaternion.hpp>

namespace asperity {
namespace {

Pose moved_along(Pose pose, const glm::dvec3& by_m) {
  pose.position_m += by_m;
  return pose;
}

Pose turned_about(const Pose& pose, const glm::dvec3& centre_m, const glm::dvec3& axis,
                  double angle_rad) {
  const glm::dmat3 turn = glm::mat3_cast(glm::angleAxis(angle_rad, axis));
  return {.rotation = turn * pose.rotation,
          .position_m = centre_m + turn * (pose.position_m - centre_m)};
}

}  // namespace

std::array<Pose, kMovedPoses> moved_poses(const Pose& pose_a, const ContactFrame& frame,
                                          const DifferenceSteps& steps) {
  const auto along = [&](const glm::dvec3& axis, double way) {
    return moved_along(pose_a, way * steps.along_m * axis);
  };
  const auto about = [&](const glm::dvec3& axis, double angle_rad) {
    return turned_about(pose_a, frame.origin_m, axis, angle_rad);
  };
  return {along(frame.u, 1.0),
          along(frame.u, -1.0),
          along(frame.v, 1.0),
          along(frame.v, -1.0),
          about(frame.u, steps.tilt_rad),
          about(frame.u, -steps.tilt_rad),
          about(frame.v, steps.tilt_rad),
          about(frame.v, -steps.tilt_rad),
          about(frame.n, steps.turn_rad),
          about(frame.n, -steps.turn_rad)};
}

void set_gradient(double here_m, const std::array<std::optional<double>, kMovedPoses>& moved_m,
                  const DifferenceSteps& steps, Penetration& result) {
  const auto rate = [&](std::size_t first, double step) {
    const std::optional<double>& forth_m = moved_m[first];
    const std::optional<double>& back_m = moved_m[first + 1];
    if (forth_m && back_m) return (*forth_m - *back_m) / (2.0 * step);
    if (forth_m) return (*forth_m - here_m) / step;
    if (back_m) return (here_m - *back_m) / step;
    return 0.0;
  };
  result.slope = {rate(0, steps.along_m), rate(2, steps.along_m)};
  result.lever_m = {rate(4, steps.tilt_rad), rate(6, steps.tilt_rad), rate(8, steps.turn_rad)};
  for (const std::size_t tilt : {std::size_t{4}, std::size_t{6}}) {
    if (!moved_m[tilt] || !moved_m[tilt + 1]) continue;
    result.spread_m = std::max(
        result.spread_m, spread_of(here_m, *moved_m[tilt], *moved_m[tilt + 1], steps.tilt_rad));
  }
}

}  // namespace asperity
