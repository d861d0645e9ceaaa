// The numbers with which a question can be answered.

#pragma once

#include <optional>

namespace asperity {

/// Both ends belong to it; an end that is absent does not limit it.
struct NumberRange {
  std::optional<double> minimum{};
  std::optional<double> maximum{};
};

}  // namespace asperity
