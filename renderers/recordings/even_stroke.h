// Declares a recorded stroke in equal steps of its path or of time.

#pragma once

#include <cstddef>
#include <vector>

#include "renderers/recordings/texture_recording.h"

namespace asperity {

/// Whether the steps of a stroke, and the lines of its spectrum, are along the path or in time.
enum class SpectrumAxis { spatial, temporal };

/// A stroke in equal steps of its axis.
struct EvenStroke {
  double step = 0.0;            ///< m or s
  std::vector<double> force{};  ///< at a normal force of 1 N, without trend
  double speed_m_per_s = 0.0;

  double length() const { return step * static_cast<double>(force.size()); }
};

/// A stroke in as many equal steps as it has samples, linear between them, so that a stroke of constant speed (or of constant
/// rate) keeps its samples. Each force is divided by N^`force_exponent`, with N the mean normal force of the stroke in newtons, and
/// the least-squares line is removed.
EvenStroke even_stroke(const RecordedStroke& stroke, SpectrumAxis axis, double force_exponent);

}  // namespace asperity
