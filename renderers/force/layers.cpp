// Implements the list of the shared layers.

#include "renderers/force/layers.h"

#include <array>

#include "renderers/force/friction.h"
#include "renderers/force/resonance.h"

namespace asperity {
namespace {

constexpr std::array kSharedLayers{
    Layer{.add_parameters = add_friction_parameters,
          .without_unused = without_unused_friction,
          .moves_by_itself = [](const ParameterValues&) { return false; },
          .band_Hz = [](const ParameterValues&) { return 0.0; }},
    Layer{.add_parameters = add_resonance_parameters,
          .without_unused = without_unused_resonance,
          .moves_by_itself =
              [](const ParameterValues& values) { return resonance_sd_N(values) > 0.0; },
          .band_Hz =
              [](const ParameterValues& values) {
                return resonance_sd_N(values) > 0.0 ? kResonanceCutoff_Hz : 0.0;
              }},
};

}  // namespace

std::span<const Layer> shared_layers() noexcept { return kSharedLayers; }

void add_layer_parameters(std::vector<Parameter>& parameters) {
  for (const Layer& layer : kSharedLayers) layer.add_parameters(parameters);
}

ParameterValues without_unused_layers(const ParameterValues& parameters) {
  ParameterValues used = parameters;
  for (const Layer& layer : kSharedLayers) used = layer.without_unused(used);
  return used;
}

}  // namespace asperity
