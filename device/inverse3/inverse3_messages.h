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
  std::string handedness{};     ///< "right", "left"; empty where not told
  std::string preset{};         ///< of the workspace; empty where not told
  std::string axes{};           ///< permutation of the basis, "XYZ"; empty where not told
  bool is_transformed = false;  ///< its workspace is moved, turned or scaled
  std::optional<double> force_gate_gain{};
  std::optional<double> damping{};
  std::optional<bool> compensates_gravity{};
  std::optional<double> gravity_scale{};
  std::optional<bool> scales_torque{};
};

struct Inverse3Inventory {
  bool has_session = false;  ///< it numbers sessions, as 3.5 does
  std::vector<Inverse3Entry> devices{};
  std::vector<std::string> grips{};  ///< ids of the wireless Verse Grips
};

/// Where the cursor of one device is. Metres, metres per second, newtons, in the service's frame. Of a vector that is
/// told, a part that is left out is zero.
struct Inverse3State {
  glm::dvec3 position_m{0.0};
  glm::dvec3 force_N{0.0};           ///< that it applies; zero where not told
  std::optional<glm::dquat> grip{};  ///< of length 1; nothing where none is told that is a turn
  std::uint32_t buttons = 0;         ///< of the grip: a, b, c
};

/// Nothing when the text is not JSON or no object.
std::optional<Inverse3Inventory> inventory_from(std::string_view message);
/// Nothing when the text is not JSON, does not speak of this device, or does not tell its position: a hand nobody knows
/// of must not be felt at the origin. `grip_id` is the grip that belongs to it; empty for none.
std::optional<Inverse3State> state_from(std::string_view message, const std::string& device_id,
                                        const std::string& grip_id = {});

/// The command for one tick. `profile` names the session, in the first message of a connection only.
std::string force_command(const std::string& device_id, ForceSpelling spelling,
                          const glm::dvec3& force_N, const std::string& profile = {});

/// "The service shapes the force: force gate 0.3, damping 0, gravity compensation 1, torque scaling on."
std::string filters_of(const Inverse3Entry& entry);

}  // namespace asperity
