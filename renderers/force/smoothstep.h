// Declares the curve by which forces fade.

#pragma once

#include <algorithm>

namespace asperity {

/// s(u) = u²(3 − 2u) on [0, 1], 0 below and 1 above: continuous with its slope, which is at most 3/2.
inline double smoothstep(double u) noexcept {
  u = std::clamp(u, 0.0, 1.0);
  return u * u * (3.0 - 2.0 * u);
}

}  // namespace asperity
