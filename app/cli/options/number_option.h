// An option that takes a number within limits.

#pragma once

#include <string>
#include <type_traits>

#include <CLI/CLI.hpp>

#include "analysis/numbers/number_text.h"
#include "results_schema/tables/table.h"

namespace asperity {

/// Refuses a text that is not a number from `least` to `most`, both included, naming them.
template <typename Number>
CLI::Validator number_within(Number least, Number most) {
  const std::string limits =
      number_text(static_cast<double>(least)) + " to " + number_text(static_cast<double>(most));
  const auto read = [least, most, limits](std::string& text) -> std::string {
    const auto number = number_in(text);
    if (number && *number >= static_cast<double>(least) && *number <= static_cast<double>(most)) {
      return {};
    }
    const char* const kind = std::is_integral_v<Number> ? "a whole number" : "a number";
    return '"' + text + "\" is not permitted; write " + kind + " from " + limits;
  };
  return {read, limits};
}

}  // namespace asperity
