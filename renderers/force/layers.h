// Declares the layers that all point models share: friction and stochastic resonance.

#pragma once

#include <vector>

#include "stimuli/properties/parameter.h"

namespace asperity {

/// Adds the parameters of the shared layers to those of a point model: friction (friction.h), then stochastic resonance
/// (resonance.h).
void add_layer_parameters(std::vector<Parameter>& parameters);

/// A model's values without those parameters of the shared layers that have no effect: of laws of friction that are not
/// chosen, and of a resonance that is switched off. With the law `rounded` and without resonance these are the values that
/// version 0.1.0 had, so that what is stored under them is found again.
ParameterValues without_unused_layers(const ParameterValues& parameters);

}  // namespace asperity
