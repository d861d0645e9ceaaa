// The numbered steps that lead to the schema of a study.

#pragma once

#include <span>
#include <string_view>

namespace asperity {

/// One step. Of several in a list each leads from the version of the one before it, and the first from an empty file.
struct Migration {
  int version = 0;  ///< the schema version to which it leads
  std::string_view sql{};
};

/// The steps of this program, in ascending order. Embedded when the program is built, so that a study can be created
/// without any file next to the program.
std::span<const Migration> migrations() noexcept;

}  // namespace asperity
