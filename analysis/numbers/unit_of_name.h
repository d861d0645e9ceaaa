// The unit in which the name of a quantity ends.

#pragma once

#include <string>
#include <string_view>

namespace asperity {

/// The name of a quantity in two parts.
struct NamedQuantity {
  std::string_view quantity{};  ///< "tool_inertia" of `tool_inertia_kg_m2`, a part of the name
  std::string_view unit{};      ///< as people write it, "kg m²"; empty of a name without a unit
};
NamedQuantity named_quantity(std::string_view name);

/// The unit as files and force models state it: "kg m2"; "1" of a name without a unit.
std::string unit_in_files(std::string_view name);

}  // namespace asperity
