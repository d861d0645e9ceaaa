// The figure of a sweep, in the form of the source's: a curve per level over texture frequency.

#pragma once

#include "app/figures/figure.h"
#include "app/tasks/sweep.h"

namespace asperity {

/// A measure over texture frequency, both logarithmic (the Pacinian power in decibels), with a parabola
/// and its peak for every level.
Figure sweep_figure(const Sweep& sweep, SweepMeasure measure = SweepMeasure::max_accel);

/// The figure `roughness` of a study (figures_of.h), whose spacings are in millimetres, and beside its estimates what a sweep predicts:
/// a measure of its strokes as small outlined marks, each level in the style of a condition, in the
/// order of both, within the study's range of spacings. An estimate has no unit, so all of the
/// measure is multiplied by one factor: both have the same geometric mean.
///
/// Errors: std::runtime_error where there are not as many levels as conditions, or nothing of the sweep
/// is within the range.
Figure beside_prediction(Figure estimates, const Sweep& sweep,
                         SweepMeasure measure = SweepMeasure::max_accel);

}  // namespace asperity
