// Reads a reference case for its figures.

#pragma once

#include <filesystem>

#include "app/findings/tidy/reference_case.h"

namespace asperity::test {

/// The case in this folder. A psychometric function has 60 draws of the bootstrap instead of a thousand: a figure needs
/// an interval and not its digits, which the tests of reference cases compare.
inline ReferenceCase case_to_draw(const std::filesystem::path& folder) {
  ReferenceCase read = read_reference_case(folder);
  if (read.family == "psyfit" && !read.input.options.has("bootstrap")) {
    read.input.options.set("bootstrap", 60.0);
  }
  return read;
}

}  // namespace asperity::test
