// Compares the virtual observer of a protocol with the parameter that its discriminations vary.

#pragma once

#include <string>
#include <vector>

#include "app/session/stimulus_builder.h"
#include "app/tasks/warnings/checked_protocol.h"
#include "protocols/file/diagnostic.h"

namespace asperity {

/// A warning for every main block of a discrimination in which the magnitude that the virtual observer judges
///
///   - does not change with the varied parameter, so that simulated responses are guesses;
///   - changes in the direction opposite to the declared effect, so that they are systematically incorrect; or
///   - changes so little that the observer, with its own noise, distinguishes no level from the standard as often as the
///     threshold requires (correct_proportion): halfway between guessing and certainty, 75 % of trials with two
///     alternatives, or as often as the staircase approaches if that is more. No threshold can then be estimated from the
///     simulated responses.
///
/// The magnitude is the mean of three simulated strokes (felt_surface), the same on the standard and on the surfaces with
/// the smallest and the largest value of the parameter, in one combination of the other factors. A change of less than 2 %
/// counts as none.
///
/// Stimuli whose files are not available are not compared (StimulusBuilder::can_make), nor an observer that ignores the
/// surfaces.
std::vector<Diagnostic> warnings_about_observer(const CheckedProtocol& checked,
                                                StimulusBuilder& builder);

}  // namespace asperity
