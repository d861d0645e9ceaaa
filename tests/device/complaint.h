// What something says that is refused.

#pragma once

#include <exception>
#include <functional>
#include <string>

namespace asperity {

/// The words of what `act` throws; empty where it throws nothing.
inline std::string complaint_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const std::exception& error) {
    return error.what();
  }
  return {};
}

}  // namespace asperity
