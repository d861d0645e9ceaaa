// A renderer that pushes upwards.

#pragma once

#include "renderers/force/force_renderer.h"

namespace asperity {

/// Pushes upwards whatever the probe does.
class SteadyPush final : public ForceRenderer {
 public:
  static constexpr double kForce_N = 1.0;
  void reset(const ProbeState&) noexcept override {}
  RenderedTick tick(const ProbeState&, double) noexcept override {
    return {.wrench = {.force_N = {0.0, 0.0, kForce_N}}};
  }
};

}  // namespace asperity
