// Draws the seed of a session or a simulation.

#pragma once

#include <cstdint>
#include <random>

namespace asperity {

/// Differs at every call.
inline std::uint64_t new_seed() {
  std::random_device source;
  return (std::uint64_t{source()} << 32U) | source();
}

}  // namespace asperity
