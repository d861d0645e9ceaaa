// Declares the value that a form writes for a key that had none.

#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "protocols/keys/names_in.h"
#include "protocols/shapes/key.h"
#include "protocols/shapes/shape.h"

namespace asperity {

/// The first name that is not taken: `wish`, `wish_2`, `wish_3`, …
std::string free_name(std::string_view wish,
                      const std::function<bool(const std::string& name)>& is_taken);
/// The same that `names` does not have.
std::string free_name(const std::vector<std::string>& names, std::string_view wish);

/// The names that the protocol declares in a registry, in their order; of the groups also the numbers, as texts.
std::vector<std::string> declared_names(const ProtocolNames& names, std::string_view registry);

/// The simplest value of the shape: the lowest number of the range that is closest to 0, the first word, the first name that the
/// registry has, an object with its required keys. A text is empty, which the check refuses where it is required; with a pattern, and without names in a registry,
/// it is "new".
nlohmann::ordered_json new_value(const ValueShape& shape, const ProtocolNames& names);

}  // namespace asperity
