// Declares how a number that may be missing is read from parameters.

#pragma once

#include <optional>
#include <string_view>
#include <variant>

#include "stimuli/properties/parameter.h"

namespace asperity {

/// The number of this name; nullopt if there is none, or a value of another kind.
inline std::optional<double> optional_number(const ParameterValues& values, std::string_view name) {
  const auto found = values.find(name);
  if (found == values.end()) return {};
  const double* const number = std::get_if<double>(&found->second);
  return number == nullptr ? std::nullopt : std::optional(*number);
}

}  // namespace asperity
