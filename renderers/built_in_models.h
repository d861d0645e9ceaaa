// The registry of the force models that the program contains.

#pragma once

#include "renderers/force/force_model.h"

namespace asperity {

/// height_map, sinusoid, stochastic, lateral_gradient, pd_gradient.
ModelRegistry built_in_models();

}  // namespace asperity
