// Declares a value of a protocol that can be bound to a factor.

#pragma once

#include <optional>
#include <string>

namespace asperity {

/// A value, or the name of the factor that supplies it.
template <class Value>
struct Binding {
  std::optional<Value> value{};
  std::string factor{};  ///< used when `value` is absent
};

}  // namespace asperity
