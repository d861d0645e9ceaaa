// Reads the members of a JSON object that follows the schema.

#pragma once

#include <functional>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

#include "protocols/design/protocol.h"
#include "protocols/keys/key.h"

namespace asperity {

/// Reads a member into `value`, which remains as it is where there is none.
template <class Value>
void read(const nlohmann::json& object, const char* key, Value& value) {
  if (const auto found = object.find(key); found != object.end()) value = found->get<Value>();
}

template <class Value>
void read(const nlohmann::json& object, const char* key, std::optional<Value>& value) {
  if (const auto found = object.find(key); found != object.end()) value = found->get<Value>();
}

/// The value of one of the schema's enumerations.
template <class Value>
void read_choice(const nlohmann::json& object, const char* key, Value& value,
                 std::initializer_list<std::pair<const char*, Value>> choices) {
  const auto found = object.find(key);
  if (found == object.end()) return;
  for (const auto& [name, choice] : choices) {
    if (*found == name) value = choice;
  }
}

inline void read(const nlohmann::json& object, const char* key, Band& band) {
  const auto found = object.find(key);
  if (found == object.end()) return;
  read(*found, "minimum", band.minimum);
  read(*found, "target", band.target);
  read(*found, "maximum", band.maximum);
}

inline void read(const nlohmann::json& object, const char* key, Binding<std::string>& binding) {
  const auto found = object.find(key);
  if (found == object.end()) return;
  if (found->is_object()) {
    binding.factor = found->at("factor").get<std::string>();
  } else {
    binding.value = found->get<std::string>();
  }
}

/// Calls `visit(name, member)` for every named member except comments.
template <class Visit>
void for_each_named(const nlohmann::json& object, const char* key, const Visit& visit) {
  const auto found = object.find(key);
  if (found == object.end()) return;
  for (const auto& [name, member] : found->items()) {
    if (!is_comment(name)) visit(name, member);
  }
}

inline Level level_of(const nlohmann::json& value) {
  return value.is_string() ? Level(value.get<std::string>()) : Level(value.get<double>());
}

/// Levels by factor, without comments.
inline std::map<std::string, Level, std::less<>> levels_of(const nlohmann::json& object) {
  std::map<std::string, Level, std::less<>> levels{};
  for (const auto& [name, member] : object.items()) {
    if (!is_comment(name)) levels[name] = level_of(member);
  }
  return levels;
}

}  // namespace asperity
