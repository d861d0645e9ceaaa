// Declares the registry of the program's force models.

#pragma once

#include <memory>

#include "renderers/compute/compute_device.h"
#include "renderers/force/force_model.h"

namespace asperity {

/// The registry of height_map, sinusoid, stochastic, lateral_gradient, pd_gradient, bump_map, normal_map, periodic,
/// solid_noise, filtered_noise, auto_regressive, recorded, data_driven, elastic_halfspace and winkler.
ModelRegistry built_in_models();

/// The same models, with the contacts of two textured bodies evaluated on a compute device instead of the processor.
ModelRegistry computed_on(std::shared_ptr<const Compute> compute, ModelRegistry models);

}  // namespace asperity
