// Declares the registry of the program's force models.

#pragma once

#include "renderers/force/force_model.h"

namespace asperity {

/// The registry of height_map, sinusoid, stochastic, lateral_gradient, pd_gradient, bump_map, normal_map, periodic,
/// solid_noise, filtered_noise, auto_regressive and recorded.
ModelRegistry built_in_models();

}  // namespace asperity
