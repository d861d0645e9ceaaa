// A text taken apart where a letter stands.

#pragma once

#include <string>
#include <vector>

namespace asperity {

/// What stands before, between and after the letters `between`, in order; empty parts are parts too, so
/// that there is at least one. Keys of findings are joined by "|".
inline std::vector<std::string> parts_of(const std::string& text, char between = '|') {
  std::vector<std::string> parts(1);
  for (const char letter : text) {
    if (letter == between) {
      parts.emplace_back();
    } else {
      parts.back() += letter;
    }
  }
  return parts;
}

}  // namespace asperity
