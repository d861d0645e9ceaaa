// The numbered steps by which the schema of a study came to be what it is.

#pragma once

#include <span>
#include <string_view>

namespace asperity {

/// The SQL that leads from schema version i to i + 1, at index i. Embedded when the program is
/// built, so that a study can be made without any file beside the program.
std::span<const std::string_view> migrations() noexcept;

}  // namespace asperity
