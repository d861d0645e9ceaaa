// The figure of a sweep, in the form of the source's: a curve per level over texture frequency.

#pragma once

#include "app/figures/figure.h"
#include "app/tasks/sweep.h"

namespace asperity {

/// Greatest acceleration over texture frequency, both logarithmic, with a parabola and its peak for
/// every level.
Figure sweep_figure(const Sweep& sweep);

}  // namespace asperity
