// Makes the figure of a sweep, in the form of the source's: a curve per level over texture
// frequency.

#pragma once

#include <string>
#include <vector>

#include "app/findings/gathering/gathered_answers.h"
#include "app/findings/outcome/figure.h"
#include "app/sweep/sweep.h"

namespace asperity {

/// A measure over texture frequency, both logarithmic (the Pacinian power in decibels), with a parabola
/// and its peak for every level.
Figure sweep_figure(const Sweep& sweep, SweepMeasure measure = SweepMeasure::max_accel);

/// Checked before hours of work: whether the figure `roughness` of a study has estimates under each
/// of these conditions (SweepBeside).
///
/// Errors: std::runtime_error that names the condition without estimates.
void require_estimates(const Figure& estimates, const std::vector<std::string>& conditions);

/// Adds the group to the axis of the figure `roughness` of a study, where it is not people:
/// simulated data are marked as such wherever the figure is used.
Figure of_group(Figure estimates, AnswerGroup group);

/// The figure `roughness` of a study (figures_of.h), whose spacings are in millimetres, with the
/// predictions of a sweep next to its estimates: a measure of its strokes as small outlined marks,
/// each level in the style of its condition and with a separate name in the legend that states the
/// model, within the study's range of spacings. `conditions` are by the sweep's levels
/// (SweepBeside). Estimates have no unit, so that the measure is multiplied by one factor: both
/// have the same geometric mean.
///
/// Errors: std::runtime_error as `require_estimates`, and where the numbers of levels and
/// conditions differ, or no row of the sweep is within the range.
Figure beside_prediction(Figure estimates, const Sweep& sweep,
                         const std::vector<std::string>& conditions,
                         SweepMeasure measure = SweepMeasure::max_accel);

}  // namespace asperity
