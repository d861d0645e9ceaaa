// Declares the search for all names in a protocol, by its tables.

#pragma once

#include <array>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace asperity {

/// A place that contains a name: the key of the member at `pointer`, or its value.
struct NameUse {
  std::string pointer{};
  bool is_key = false;
  bool is_in_formula = false;  ///< the value is a formula that contains the name
  std::string registry{};      ///< as in NameShape; of a level, that of its factor (levels_of)
  std::string name{};
  bool is_declared = false;  ///< the thing that has the name is here
};

/// All names of a protocol that refer to something or that something can refer to.
struct ProtocolNames {
  std::vector<NameUse> uses{};  ///< in the order of the walk, which is that of the tables
  /// Two registries in which a name is the same thing: the levels of a factor are textures where the texture of a stimulus
  /// is bound to the factor.
  std::vector<std::pair<std::string, std::string>> links{};
  /// The registry of the groups of participants: that of the levels of their factor. Empty without groups.
  std::string groups{};
  /// Levels of that factor that are numbers, as texts: they have no names, and a screen states the number as a text.
  std::vector<std::string> numbers_of_groups{};

  /// A name that no value declares, such as that of a test, and what it means: that of each thing with this name.
  struct Offered {
    std::string name{};
    std::vector<std::string_view> meanings{};
  };
  /// By registry or part of one: names that follow from the blocks (form/offered_names.h).
  std::map<std::string_view, std::vector<Offered>> offered{};
};

/// The registry of the levels of a factor.
std::string levels_of(std::string_view factor);

/// The names of a protocol, in one walk over its values. The protocol may be invalid: values without the form of their key
/// contain no names.
ProtocolNames names_in(const nlohmann::json& protocol);

/// The keys that can have the name of an entry of a list.
inline constexpr std::array<std::string_view, 2> kNamesOfEntries{"name", "value"};
/// The name of an entry of a list; empty without one.
std::string_view name_of_entry(const nlohmann::json& entry);

/// The declaration of a name by the value at the pointer, or with `is_key` by the key of the member; null if there is none.
const NameUse* declaration_at(const ProtocolNames& names, const std::string& pointer, bool is_key);

/// The places that contain the name of one thing: a level that is a texture also as a texture. The reverse holds only for a
/// factor that has this level.
std::vector<NameUse> uses_of(const ProtocolNames& names, const std::string& registry,
                             std::string_view name);
/// The registries in which the name is the same thing.
std::set<std::string> registries_of(const ProtocolNames& names, const std::string& registry,
                                    std::string_view name);

}  // namespace asperity
