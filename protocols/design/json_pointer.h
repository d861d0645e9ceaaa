// Places in a JSON document.

#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace asperity {

/// `pointer` (RFC 6901) followed by a key or an index.
std::string pointer_to(const std::string& pointer, std::string_view key);
std::string pointer_to(const std::string& pointer, std::size_t index);

}  // namespace asperity
