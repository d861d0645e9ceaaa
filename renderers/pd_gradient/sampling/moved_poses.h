// Declares the ten configurations of A for central differences, and the gradient from the depths there.

#pragma once

#include <array>
#include <optional>

#include "renderers/pd_gradient/sampling/penetration.h"

namespace asperity {

inline constexpr std::size_t kMovedPoses = 10;

/// A moved forth and back along u and v, then turned forth and back about u, v and n through the frame's origin.
std::array<Pose, kMovedPoses> moved_poses(const Pose& pose_a, const ContactFrame& frame,
                                          const DifferenceSteps& steps);

/// Sets slope, lever and spread from the depth here and those of the moved poses; nullopt: no overlap. If one of the two
/// configurations of a difference has no overlap, the difference is one-sided; if both have none, it is 0.
void set_gradient(double here_m, const std::array<std::optional<double>, kMovedPoses>& moved_m,
                  const DifferenceSteps& steps, Penetration& result);

}  // namespace asperity
