// Declares where the keys of a protocol apply: the conditions of their rows, in a whole protocol.

#pragma once

#include <set>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "protocols/shapes/key.h"

namespace asperity {

/// The kinds of experiment to which the object at `pointer` belongs: that of its block, or those of all blocks. The protocol
/// may be invalid.
std::set<std::string> kinds_at(const nlohmann::json& protocol, const std::string& pointer);

/// The first condition of a key that does not hold for the object at `pointer`, which need not be in the protocol yet; null
/// where the key applies, and where it is permitted (InapplicableKey::is_permitted).
const KeyCondition* unmet_condition(const ProtocolKey& key, const nlohmann::json& object,
                                    const nlohmann::json& protocol, const std::string& pointer);

/// A key that is stated where it does not apply.
struct InapplicableKey {
  std::string pointer{};
  const KeyCondition* condition = nullptr;
  /// Only to another kind, and its value is the default: equivalent to its absence, and permitted. It must not be read,
  /// because it would replace what the kind states.
  bool is_permitted = false;
};
/// The keys of a protocol that are stated where they do not apply. The form of the protocol may be invalid.
std::vector<InapplicableKey> inapplicable_keys(const nlohmann::json& protocol);
/// The protocol without some of them.
nlohmann::json without_keys(nlohmann::json protocol, const std::vector<InapplicableKey>& keys);

}  // namespace asperity
