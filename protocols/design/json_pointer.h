// Declares functions for JSON pointers.

#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace asperity {

/// Appends a key or an index to `pointer` (RFC 6901).
std::string pointer_to(const std::string& pointer, std::string_view key);
std::string pointer_to(const std::string& pointer, std::size_t index);

}  // namespace asperity
