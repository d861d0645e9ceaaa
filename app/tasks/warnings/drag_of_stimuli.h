// Declares the mean drag of the stimuli of a protocol.

#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/session/explored_stimuli.h"
#include "app/session/stimulus_builder.h"
#include "app/tasks/warnings/checked_protocol.h"

namespace asperity {

/// The mean drag of a stimulus in the strokes of an exploration.
struct StimulusDrag {
  std::string stimulus{};
  std::string exploration{};
  double mean_N = 0.0;  ///< for a hand that presses with the mean normal force of the exploration
  double of_coulomb = 1.0;  ///< over the mean of μ·F_n(t)
};

/// The drag of every stimulus with friction, once for each exploration that requests a speed, at the speed and the normal
/// force at which the exploration aims: that of sliding_drag, along x, of a point model on a body as on a plane. A model that has
/// only the law `rounded` (`pd_gradient`) has μ·F_n/√(1 + (v₀/v)²). Stimuli whose files are not available
/// (StimulusBuilder::can_make), those that cannot be rendered and those without a contact at this force are left out.
std::vector<StimulusDrag> drag_of_stimuli(const CheckedProtocol& checked, StimulusBuilder& builder,
                                          const StimuliCourse& course = {});

/// A line that states what the mean drag is and why to compare it, then "mean drag 0.198 N, 99.2 % of friction × normal
/// force: fine, coarse (exploration stroke)", one line for all stimuli of an exploration with the same numbers. Of more
/// than eight, such as the levels of a staircase, it counts the others. Empty without drags.
std::vector<std::string> drag_lines(std::span<const StimulusDrag> drags);

}  // namespace asperity
