// What a renderer answers to one sample of the hand.

#pragma once

#include "device/wrench.h"

namespace asperity {

struct RenderedTick {
  Wrench wrench{};
  /// How deep the probe is in the surface, texture included; 0 exactly when they do not touch.
  double penetration_m = 0.0;
};

}  // namespace asperity
