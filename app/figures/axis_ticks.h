// Computes the ticks of an axis and their labels.

#pragma once

#include <string>
#include <vector>

#include "app/findings/figure.h"

namespace asperity {

/// Lengths are stored in metres and drawn in millimetres.
inline constexpr double kMillimetresPerMetre = 1e3;
/// How far a logarithmic axis extends beyond the outermost marks, as a factor.
inline constexpr double kBeyondMarks = 1.12;

struct AxisTick {
  double value = 0.0;
  Phrase label{};  ///< empty: a tick between labelled ones
};

/// About `labels` ticks on a linear axis, at round numbers; on a logarithmic axis at 1 to 9 times
/// powers of ten, of which at least three are labelled; on places one each.
std::vector<AxisTick> ticks_of(const FigureAxis& axis, int labels);

}  // namespace asperity
