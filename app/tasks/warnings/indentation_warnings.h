// Compares the normal forces of a protocol with the assumptions of models that have their own law of indentation.

#pragma once

#include <string>
#include <vector>

#include "app/session/stimulus_builder.h"
#include "app/tasks/warnings/checked_protocol.h"
#include "protocols/file/diagnostic.h"

namespace asperity {

/// A warning for every stimulus, once for each exploration, under which the normal force of the exploration (habits_for)
/// violates an assumption of its model on a surface without texture (indentation_law.h): small strains of
/// elastic_halfspace.
///
/// Stimuli whose files are not available are left out (StimulusBuilder::can_make). The files have been checked before.
std::vector<Diagnostic> warnings_about_indentation(const CheckedProtocol& checked,
                                                   StimulusBuilder& builder);

}  // namespace asperity
