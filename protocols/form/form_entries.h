// Declares the fields of a form: which values an object of a protocol has or can have, and how they are named.

#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "protocols/shapes/key.h"

namespace asperity {

/// A key of an object, with or without a value.
struct FormEntry {
  std::string pointer{};             ///< of the value, or of the one that the key would have
  const ProtocolKey* key = nullptr;  ///< never null
  bool is_present = false;
};

/// The entries of an object at `pointer` in a protocol, in the order of its table. Keys without a value are left out where
/// they do not apply: of a table whose objects have one of several keys those that the present one excludes, and
/// everywhere those whose conditions do not hold.
std::vector<FormEntry> entries_of(const KeyTable& table, const nlohmann::json& object,
                                  const std::string& pointer, const nlohmann::json& protocol);

/// The keys of an object that its table does not have, except for comments.
std::vector<std::string> unknown_keys(const KeyTable& table, const nlohmann::json& object);

/// The shape of a number as it is displayed at this place: without a unit of its own, the one in which the name of the
/// key or of the object around it ends ("speed_m_per_s", of all three numbers of the band).
NumberShape displayed_shape(const NumberShape& shape, const std::string& pointer);

/// A part of the path to a value: a label of a key, in English, or a name of the author.
struct PathPart {
  std::string text{};
  bool is_label = false;
  const KeyTable* table = nullptr;  ///< of the object that the value here is; null: another value
};
/// The path to a value as a form writes it: "Blocks", "main", "Questions", "rough", "Question". Entries of lists have
/// their name or value, or else their position from 1.
std::vector<PathPart> path_of(const nlohmann::json& protocol, const std::string& pointer);

/// What the value of the shape at this place contains, in a line: the first texts and numbers of an object in the order of its
/// table, without its name. Numbers are in the unit of the form; words of choices have the name that `name_of` gives them.
std::string summary_of(
    const ValueShape& shape, const nlohmann::json& value, const std::string& pointer,
    const std::function<std::string(std::string_view word)>& name_of = [](std::string_view word) {
      return std::string(word);
    });

}  // namespace asperity
