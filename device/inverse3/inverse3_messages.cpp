// What Haply's Inverse Service says, and what is said to it.

#include "device/inverse3/inverse3_messages.h"

#include <utility>

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "analysis/numbers/number_text.h"

namespace asperity {
namespace {

using nlohmann::json;

// Null for whatever is not there: services leave out what they hold for obvious.
const json& at(const json& object, const char* key) {
  static const json kNothing;
  if (!object.is_object()) return kNothing;
  const auto found = object.find(key);
  return found == object.end() ? kNothing : *found;
}

double number_or(const json& value, double otherwise) {
  return value.is_number() ? value.get<double>() : otherwise;
}

std::string text_or_none(const json& value) {
  return value.is_string() ? value.get<std::string>() : std::string();
}

std::optional<double> number_if_there(const json& value) {
  if (!value.is_number()) return std::nullopt;
  return value.get<double>();
}

std::optional<bool> flag_if_there(const json& value) {
  if (!value.is_boolean()) return std::nullopt;
  return value.get<bool>();
}

// Nothing where no vector is told: neither an empty object nor words in place of numbers are one.
std::optional<glm::dvec3> vector_if_there(const json& value) {
  if (!value.is_object() || value.empty()) return std::nullopt;
  glm::dvec3 vector(0.0);
  const char* const names[] = {"x", "y", "z"};
  for (int axis = 0; axis < 3; ++axis) {
    const json& part = at(value, names[axis]);
    if (!part.is_null() && !part.is_number()) return std::nullopt;
    vector[axis] = number_or(part, 0.0);
  }
  return vector;
}

// Nothing told is no turn; four zeros are none that anything could have.
std::optional<glm::dquat> turn_of(const json& value) {
  if (!value.is_object() || value.empty()) return glm::dquat(1.0, 0.0, 0.0, 0.0);
  const glm::dvec3 axis = vector_if_there(value).value_or(glm::dvec3(0.0));
  const glm::dquat turn(number_or(at(value, "w"), 0.0), axis.x, axis.y, axis.z);
  constexpr double kShortest = 0.5;  // of what should be 1
  const double length = glm::length(turn);
  if (!(length > kShortest && length < 1.0 / kShortest)) return std::nullopt;
  return turn / length;
}

bool is_identity(const json& transform) {
  const glm::dvec3 moved_m = vector_if_there(at(transform, "position")).value_or(glm::dvec3(0.0));
  const glm::dvec3 scaled = vector_if_there(at(transform, "scale")).value_or(glm::dvec3(1.0));
  const std::optional<glm::dquat> turned = turn_of(at(transform, "rotation"));
  constexpr double kClose = 1e-9;
  return glm::length(moved_m) < kClose && glm::length(scaled - glm::dvec3(1.0)) < kClose &&
         turned && glm::length(glm::dvec3(turned->x, turned->y, turned->z)) < kClose;
}

// "defaults", or {"preset": "defaults"}.
std::string preset_of(const json& config) {
  const json& preset = at(config, "preset");
  return preset.is_object() ? text_or_none(at(preset, "preset")) : text_or_none(preset);
}

Inverse3Entry entry_of(const json& device) {
  const json& config = at(device, "config");
  const json& gravity = at(config, "gravity_compensation");
  const json& filters = at(config, "filters");
  return {.id = text_or_none(at(device, "device_id")),
          .handedness = text_or_none(at(config, "handedness")),
          .preset = preset_of(config),
          .axes = text_or_none(at(at(config, "basis"), "permutation")),
          .is_transformed = !is_identity(at(at(config, "mount"), "transform")) ||
                            !is_identity(at(at(device, "state"), "transform")),
          .force_gate_gain = number_if_there(at(at(filters, "force_gate"), "gain")),
          .damping = number_if_there(at(at(filters, "damping"), "scalar")),
          .compensates_gravity = flag_if_there(at(gravity, "enabled")),
          .gravity_scale = number_if_there(at(gravity, "scaling_factor")),
          .scales_torque = flag_if_there(at(at(config, "torque_scaling"), "enabled"))};
}

std::string told(const std::optional<double>& number) {
  return number ? number_text(*number) : "not reported";
}

std::string told(const std::optional<bool>& flag) {
  if (!flag) return "not reported";
  return *flag ? "on" : "off";
}

}  // namespace

std::optional<Inverse3Inventory> inventory_from(std::string_view message) {
  const json root = json::parse(message, nullptr, /*allow_exceptions=*/false);
  if (!root.is_object()) return std::nullopt;
  Inverse3Inventory inventory{.has_session = root.contains("session_id")};
  for (const json& device : at(root, "inverse3")) {
    Inverse3Entry entry = entry_of(device);
    if (!entry.id.empty()) inventory.devices.push_back(std::move(entry));
  }
  for (const json& grip : at(root, "wireless_verse_grip")) {
    std::string id = text_or_none(at(grip, "device_id"));
    if (!id.empty()) inventory.grips.push_back(std::move(id));
  }
  return inventory;
}

std::optional<Inverse3State> state_from(std::string_view message, const std::string& device_id,
                                        const std::string& grip_id) {
  const json root = json::parse(message, nullptr, /*allow_exceptions=*/false);
  for (const json& device : at(root, "inverse3")) {
    if (text_or_none(at(device, "device_id")) != device_id) continue;
    const json& state = at(device, "state");
    const std::optional<glm::dvec3> position_m = vector_if_there(at(state, "cursor_position"));
    if (!position_m) return std::nullopt;
    Inverse3State found{
        .position_m = *position_m,
        .force_N = vector_if_there(at(state, "current_cursor_force")).value_or(glm::dvec3(0.0))};
    for (const json& grip : at(root, "wireless_verse_grip")) {
      if (grip_id.empty() || text_or_none(at(grip, "device_id")) != grip_id) continue;
      const json& told = at(grip, "state");
      if (!told.is_object()) break;
      found.grip = turn_of(at(told, "orientation"));
      const char* const names[] = {"a", "b", "c"};
      for (unsigned int i = 0; i < 3; ++i) {
        if (flag_if_there(at(at(told, "buttons"), names[i])).value_or(false))
          found.buttons |= 1U << i;
      }
      break;
    }
    return found;
  }
  return std::nullopt;
}

std::string force_command(const std::string& device_id, ForceSpelling spelling,
                          const glm::dvec3& force_N, const std::string& profile) {
  std::string text = "{";
  if (!profile.empty()) {
    text += R"("session":{"configure":{"profile":{"name":)" + json(profile).dump() + "}}},";
  }
  text += R"("inverse3":[{"device_id":)" + json(device_id).dump() +
          R"(,"commands":{"set_cursor_force":{)";
  text += spelling == ForceSpelling::vector ? R"("vector")" : R"("values")";
  text += R"(:{"x":)" + number_text(force_N.x) + R"(,"y":)" + number_text(force_N.y) + R"(,"z":)" +
          number_text(force_N.z) + "}}}}]}";
  return text;
}

std::string filters_of(const Inverse3Entry& entry) {
  const bool is_compensating = entry.compensates_gravity.value_or(false);
  return "The service modifies the force: force gate " + told(entry.force_gate_gain) +
         ", damping " + told(entry.damping) + ", gravity compensation " +
         (is_compensating ? told(entry.gravity_scale) : told(entry.compensates_gravity)) +
         ", torque scaling " + told(entry.scales_torque) + ".";
}

}  // namespace asperity
