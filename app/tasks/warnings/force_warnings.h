// Compares the force that a protocol requests of the hand with the force that its surfaces can exert.

#pragma once

#include <string>
#include <vector>

#include "app/session/explored_stimuli.h"
#include "app/session/stimulus_builder.h"
#include "app/tasks/warnings/checked_protocol.h"
#include "protocols/file/diagnostic.h"

namespace asperity {

/// A warning for every stimulus on a plane, once for each exploration, whose force stays below the normal force that its exploration requests (the
/// target, without a target the minimum): beyond its greatest depth such a surface exerts a constant force, so that the
/// instruction cannot be followed and the texture is no longer felt.
///
/// The force is that on a probe at rest, at the centre and on a circle around it, for depths up to that of the force limit
/// and at least 2 cm. Bodies are not compared, nor
/// stimuli whose files are not available (StimulusBuilder::can_make). Of varied levels those near the limit are examined
/// (for_each_stimulus_near_limit). The files have been checked before.
std::vector<Diagnostic> warnings_about_forces(const CheckedProtocol& checked,
                                              StimulusBuilder& builder,
                                              const StimuliCourse& course = {});

}  // namespace asperity
