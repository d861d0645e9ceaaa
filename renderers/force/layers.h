// Declares the layers that all point models share: friction and stochastic resonance.

#pragma once

#include <span>
#include <vector>

#include "stimuli/properties/parameter.h"

namespace asperity {

/// A layer of every point model: its parameters, and how it changes the properties of a surface.
struct Layer {
  void (*add_parameters)(std::vector<Parameter>&) = nullptr;
  /// The values without those of this layer that have no effect.
  ParameterValues (*without_unused)(const ParameterValues&) = nullptr;
  /// Whether the force on a probe that holds still keeps changing because of this layer; the force then has no potential.
  bool (*moves_by_itself)(const ParameterValues&) = nullptr;
  /// The highest frequency of the force that this layer adds [Hz]; 0 for a layer that adds none of its own.
  double (*band_Hz)(const ParameterValues&) = nullptr;
};

/// Friction (friction.h), then stochastic resonance (resonance.h). Friction adds no force over time to a probe that holds
/// still, and a potential is a property of the force without friction.
std::span<const Layer> shared_layers() noexcept;

/// Adds the parameters of the shared layers to those of a point model.
void add_layer_parameters(std::vector<Parameter>& parameters);

/// A model's values without those parameters of the shared layers that have no effect: of laws of friction that are not
/// chosen, and of a resonance that is switched off.
ParameterValues without_unused_layers(const ParameterValues& parameters);

}  // namespace asperity
