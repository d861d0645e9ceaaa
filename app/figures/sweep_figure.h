// The figure of a sweep, in the form of the source's: a curve per level over texture frequency.

#pragma once

#include <string>
#include <vector>

#include "app/findings/figure.h"
#include "app/findings/study/gathered_answers.h"
#include "app/sweep/sweep.h"

namespace asperity {

/// A measure over texture frequency, both logarithmic (the Pacinian power in decibels), with a parabola
/// and its peak for every level.
Figure sweep_figure(const Sweep& sweep, SweepMeasure measure = SweepMeasure::max_accel);

/// Before hours of work: whether the figure `roughness` of a study has estimates under each of these
/// conditions (SweepBeside).
///
/// Errors: std::runtime_error that names the condition without any.
void require_estimates(const Figure& estimates, const std::vector<std::string>& conditions);

/// The figure `roughness` of a study with whose estimates they are at its axis, where they are not those
/// of people: what is simulated says so wherever the figure goes.
Figure of_group(Figure estimates, AnswerGroup group);

/// The figure `roughness` of a study (figures_of.h), whose spacings are in millimetres, and beside its
/// estimates what a sweep predicts: a measure of its strokes as small outlined marks, each level in the
/// style of its condition and with a name of their own in the key, which says the model, within the study's
/// range of spacings. `conditions` are by the sweep's levels
/// (SweepBeside). An estimate has no unit, so all of the measure is multiplied by one factor: both have
/// the same geometric mean.
///
/// Errors: std::runtime_error as `require_estimates`, and where there are not as many levels as
/// conditions, or nothing of the sweep is within the range.
Figure beside_prediction(Figure estimates, const Sweep& sweep,
                         const std::vector<std::string>& conditions,
                         SweepMeasure measure = SweepMeasure::max_accel);

}  // namespace asperity
