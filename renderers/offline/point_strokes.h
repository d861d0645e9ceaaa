// Declares strokes and stimuli for measurements of the time of point models.

#pragma once

#include <cstddef>
#include <vector>

#include "device/probe_state.h"
#include "renderers/force/force_model.h"

namespace asperity {

/// The duration of a tick of these strokes.
inline constexpr double kStrokeTick_s = 1e-3;

/// To and fro over 60 mm at up to 94 mm/s, drifting sideways, at a height above the plane.
std::vector<ProbeState> stroke_on_plane(std::size_t ticks, double height_m);

/// Around the tube of `bumpy_torus` (stimuli/meshes/detailed_bodies.h) at 200 mm/s, 1 mm below its surface.
std::vector<ProbeState> stroke_on_torus(std::size_t ticks);

/// What any point model of a registry needs on a plane: a height field of 2000 × 2000 random heights over 0.1 m, which is larger
/// than a cache, as that of a photograph is, and the files that the models make of it.
RendererInputs rough_plane(const ModelRegistry& models);

}  // namespace asperity
