// A kind of synthetic surface with its parameters, and the square that a surface covers.

#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "stimuli/properties/parameter.h"

namespace asperity {

/// A kind of synthetic surface, by its name in the command line and in a sidecar.
struct SurfaceDeclaration {
  std::string kind{};
  Phrase summary{};
  std::vector<Parameter> parameters{};
};

/// The square that the surface covers. The pitch is width_m/pixels.
struct SurfaceCanvas {
  double width_m = 0.10;
  std::size_t pixels = 1024;  ///< per side
  std::uint64_t seed = 1;     ///< of all random numbers of the surface
};

}  // namespace asperity
