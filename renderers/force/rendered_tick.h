// Declares the result of a renderer for one sample.

#pragma once

#include "device/wrench.h"

namespace asperity {

struct RenderedTick {
  Wrench wrench{};
  /// Depth of the probe in the surface, texture included; 0 exactly if they are not in contact.
  double penetration_m = 0.0;
};

}  // namespace asperity
