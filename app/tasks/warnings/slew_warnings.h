// Finds the stimuli whose force grows or turns faster than the limiter permits.

#pragma once

#include <string>
#include <vector>

#include "app/session/explored_stimuli.h"
#include "app/session/stimulus_builder.h"
#include "app/tasks/warnings/checked_protocol.h"
#include "protocols/file/diagnostic.h"

namespace asperity {

/// A warning for every stimulus on a plane, once for each exploration, whose force grows or turns within a millisecond by
/// more than the limiter of every device permits (ForceLimits::slew_N): another texture is then felt than the protocol
/// describes. The amplitude is that of a session, also where equal texture force is requested.
///
/// The probe strokes across the patch in both directions of the exploration, at the constant depth at which the mean
/// normal force is the requested one, at the greatest speed of its band. A band without a maximum counts with its target
/// or minimum; without a band the force is 1 N and the speed 300 mm/s, that of a fast free stroke. It also comes down on eight
/// places along the stroke, straight and at the speed of the simulated hand (HandHabits::approach_speed_m_per_s), to the depth at
/// which the plane alone would give the force. Bodies are not compared, nor stimuli that cannot be rendered or whose files are
/// not available (StimulusBuilder::can_make). Of varied levels those near the limit are examined (for_each_stimulus_near_limit).
std::vector<Diagnostic> warnings_about_slew(const CheckedProtocol& checked,
                                            StimulusBuilder& builder,
                                            const StimuliCourse& course = {});

}  // namespace asperity
