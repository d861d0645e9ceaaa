// Bodies and probes that the tests of point models on bodies share.

#pragma once

#include <cmath>
#include <memory>

#include "renderers/force/force_model.h"
#include "renderers/proxy/body_surface.h"
#include "stimuli/meshes/solid_body.h"
#include "tests/renderers/surfaces.h"

namespace asperity {

inline constexpr double kBodyStiffness_N_per_m = 1000.0;
inline constexpr double kGlobeRadius_m = 0.02;

inline const std::shared_ptr<const BodySurface>& sphere() {
  static const auto kSphere = std::make_shared<const BodySurface>(
      placed(body_mesh(SphereShape{2.0 * kGlobeRadius_m}, nullptr), BodyRole::surface));
  return kSphere;
}

inline const std::shared_ptr<const BodySurface>& flat_plate() {
  static const auto kPlate =
      std::make_shared<const BodySurface>(body_mesh(PlateShape{{0.14, 0.02, 0.004}}, nullptr));
  return kPlate;
}

inline RendererInputs inputs_on_body(const std::shared_ptr<const BodySurface>& body) {
  RendererInputs inputs;
  inputs.material = {.stiffness_N_per_m = kBodyStiffness_N_per_m, .friction = 0.0};
  inputs.patch = wide_patch();
  inputs.height_field = grating();
  inputs.assets = files_of_models();
  inputs.seed = 1;
  inputs.body = body;
  return inputs;
}

/// A probe at an angle from one axis of the globe's frame to another one.
inline ProbeState between_axes(int from, int to, double angle_rad, double radius_m) {
  ProbeState probe;
  probe.position_m[from] = radius_m * std::cos(angle_rad);
  probe.position_m[to] = radius_m * std::sin(angle_rad);
  probe.position_m.z -= kGlobeRadius_m;
  return probe;
}

}  // namespace asperity
