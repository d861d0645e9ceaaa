// Registers the force models that the program contains. A new model adds its include and its line here.

#include "renderers/built_in_models.h"

#include <utility>

#include "renderers/models/auto_regressive.h"
#include "renderers/models/bump_map.h"
#include "renderers/models/data_driven.h"
#include "renderers/models/elastic_halfspace.h"
#include "renderers/models/filtered_noise.h"
#include "renderers/models/height_map.h"
#include "renderers/models/lateral_gradient.h"
#include "renderers/models/normal_map.h"
#include "renderers/models/periodic.h"
#include "renderers/models/recorded.h"
#include "renderers/models/sinusoid.h"
#include "renderers/models/solid_noise.h"
#include "renderers/models/stochastic.h"
#include "renderers/models/winkler.h"
#include "renderers/pd_gradient/contact/pd_gradient.h"

namespace asperity {

ModelRegistry built_in_models() {
  ModelRegistry registry;
  registry.add(height_map_model());
  registry.add(sinusoid_model());
  registry.add(stochastic_model());
  registry.add(lateral_gradient_model());
  registry.add(pd_gradient_model());
  registry.add(bump_map_model());
  registry.add(normal_map_model());
  registry.add(periodic_model());
  registry.add(solid_noise_model());
  registry.add(filtered_noise_model());
  registry.add(auto_regressive_model());
  registry.add(recorded_model());
  registry.add(data_driven_model());
  registry.add(elastic_halfspace_model());
  registry.add(winkler_model());
  return registry;
}

ModelRegistry computed_on(std::shared_ptr<const Compute> compute, ModelRegistry models) {
  models.replace(pd_gradient_model(std::move(compute)));
  return models;
}

}  // namespace asperity
