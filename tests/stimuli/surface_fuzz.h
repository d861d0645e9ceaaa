// Mutated files of measured surfaces.

#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "stimuli/measured/measured_surface.h"

namespace asperity::test {

struct FuzzTally {
  std::size_t accepted = 0;
  std::size_t refused = 0;
};

/// Decodes mutated files of one format, and converts what is accepted, until `is_enough` is true, which is asked after every file.
///
/// Errors: std::logic_error for a refusal without the name of the file, and everything that is not a refusal.
FuzzTally fuzz_surfaces(SurfaceFormat format,
                        const std::function<bool(const FuzzTally&)>& is_enough);

}  // namespace asperity::test
