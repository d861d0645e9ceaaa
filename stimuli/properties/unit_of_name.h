// The unit that the name of a quantity ends with.

#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace asperity {

/// "N/m" of `stiffness_N_per_m`; nothing of a name that ends with no unit.
std::optional<std::string> unit_at_end_of(std::string_view name);

}  // namespace asperity
