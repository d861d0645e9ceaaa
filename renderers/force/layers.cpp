// Implements the list of the shared layers.

#include "renderers/force/layers.h"

#include "renderers/force/friction.h"
#include "renderers/force/resonance.h"

namespace asperity {

void add_layer_parameters(std::vector<Parameter>& parameters) {
  add_friction_parameters(parameters);
  add_resonance_parameters(parameters);
}

ParameterValues without_unused_layers(const ParameterValues& parameters) {
  return without_unused_resonance(without_unused_friction(parameters));
}

}  // namespace asperity
