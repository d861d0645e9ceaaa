// Computes the ticks of an axis and their labels.

#pragma once

#include <string>
#include <vector>

#include "app/findings/outcome/figure.h"

namespace asperity {

struct AxisTick {
  double value = 0.0;
  Phrase label{};  ///< empty: a tick between labelled ones
};

/// About `labels` ticks on a linear axis, at round numbers, and at least two; on a logarithmic axis
/// at 1 to 9 times powers of ten where at least three of them are labelled, otherwise at round
/// numbers as on a linear axis; on places one each.
std::vector<AxisTick> ticks_of(const FigureAxis& axis, int labels);

}  // namespace asperity
