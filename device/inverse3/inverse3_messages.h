// What Haply's Inverse Service says, and what is said to it.

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

namespace asperity {

/// How a service spells the force in a command: "values" until 3.4, "vector" in the documents of 3.5.
enum class ForceSpelling { vector, values };

/// One Inverse3 in the first message of a connection, with what shapes its force.
struct Inverse3Entry {
  std::string id{};
  std::string handedness{};  ///< "right", "left"; empty where not told
  std::string preset{};      ///< of the workspace; empty where not told
  std::string axes{};        ///< permutation of the basis, "XYZ"; empty where not told
  std::optional<double> force_gate_gain{};
  std::optional<double> damping{};
  std::optional<bool> compensates_gravity{};
  std::optional<double> gravity_scale{};
  std::optional<bool> scales_torque{};
};

struct Inverse3Inventory {
  bool has_session = false;  ///< it numbers sessions, as 3.5 does
  std::vector<Inverse3Entry> devices{};
  bool has_grip = false;  ///< a wireless Verse Grip is there
};

/// Where the cursor of one device is. Metres, metres per second, newtons, in the service's frame; what a message
/// leaves out is zero, or no turn.
struct Inverse3State {
  glm::dvec3 position_m{0.0};
  glm::dvec3 force_N{0.0};  ///< that it applies
  glm::dquat grip{1.0, 0.0, 0.0, 0.0};
  std::uint32_t buttons = 0;  ///< of the grip: a, b, c
};

/// Nothing when the text is not JSON or no object.
std::optional<Inverse3Inventory> inventory_from(std::string_view message);
/// Nothing when the text is not JSON or does not speak of this device.
std::optional<Inverse3State> state_from(std::string_view message, const std::string& device_id);

/// The command for one tick. `profile` names the session, in the first message of a connection only.
std::string force_command(const std::string& device_id, ForceSpelling spelling,
                          const glm::dvec3& force_N, const std::string& profile = {});

/// "The service shapes the force: force gate 0.3, damping 0, gravity compensation 1, torque scaling on."
std::string filters_of(const Inverse3Entry& entry);

}  // namespace asperity
