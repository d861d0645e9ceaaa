// A text with a part replaced, for a test that changes one place of a file.

#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace asperity {

/// The text with `to` in the place of the first `from`; throws std::invalid_argument where there is none.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::invalid_argument("the text has no " + from);
  return text.replace(at, from.size(), to);
}

}  // namespace asperity
