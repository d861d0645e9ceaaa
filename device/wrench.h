// What the surface does to the hand.

#pragma once

#include <glm/vec3.hpp>

namespace asperity {

/// Force and torque on the hand, about the probe's tip, in the device's frame.
struct Wrench {
  glm::dvec3 force_N{0.0};
  glm::dvec3 torque_N_m{0.0};
};

}  // namespace asperity
