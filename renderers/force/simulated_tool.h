// Declares the interface of renderers that simulate a tool between the hand and the surface.

#pragma once

#include <optional>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

namespace asperity {

/// The pose of a tool: the position of its tip, the origin of its frame, and its orientation, in the frame of the device.
struct TipPose {
  glm::dvec3 position_m{0.0};
  glm::dquat orientation{1.0, 0.0, 0.0, 0.0};
};

/// Implemented by a renderer (ForceRenderer) whose tool need not be where the device is.
///
/// Threads: as ForceRenderer::limits.
class SimulatesTool {
 public:
  virtual ~SimulatesTool() = default;
  SimulatesTool(const SimulatesTool&) = delete;
  SimulatesTool& operator=(const SimulatesTool&) = delete;

  /// The tool after the last tick, or after `reset`; nullopt if its pose is that of the device.
  virtual std::optional<TipPose> simulated_tool() const noexcept = 0;

 protected:
  SimulatesTool() = default;
};

}  // namespace asperity
