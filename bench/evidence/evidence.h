// Declares the measurements for tables of the documents; each prints its numbers as text.

#pragma once

#include <cstdint>
#include <string>

namespace asperity {

/// docs/models/friction.md: the properties of each law, and the vibration that it causes under a stroking hand, on simulated devices.
void print_friction();

/// docs/models/pd_gradient.md: how much the force of pd_gradient changes in a tick where contacts begin, end, divide and merge,
/// beyond the change that the motion explains, and its net and gross work on closed paths.
void print_pd_continuity();

/// docs/models/pd_gradient.md: how far the forces and torques of pd_gradient are from the truth.
void print_pd_errors();

/// Numbers of strokes, in turn over the force models and the simulated devices.
struct DetectionSeries {
  std::uint64_t clean = 2000;
  std::uint64_t planted = 500;
  std::uint64_t seed = 1;
  std::string model{};  ///< all models, those of a point ("point"), or the one with this id
};

/// docs/instability.md: how well the detector of buzz separates strokes with a planted oscillation from strokes without one, and the
/// cost of a judgement. A stroke of pd_gradient takes seconds.
///
/// Errors: std::invalid_argument for an unknown model.
void print_perceived_instability(const DetectionSeries& order);

}  // namespace asperity
