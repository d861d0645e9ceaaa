// Declares the result of a renderer for one sample.

#pragma once

#include <cstdint>

#include "device/wrench.h"

namespace asperity {

struct RenderedTick {
  Wrench wrench{};
  /// Depth of the probe in the surface, texture included; 0 exactly if they are not in contact.
  double penetration_m = 0.0;
  /// Of a renderer of several surfaces: the number of the one that the probe is on, from 1; 0 elsewhere and for
  /// others.
  std::uint32_t part = 0;
};

}  // namespace asperity
