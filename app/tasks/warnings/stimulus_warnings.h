// Lists all warnings about the stimuli of a protocol and about how they are presented.

#pragma once

#include <string>
#include <vector>

#include "app/session/explored_stimuli.h"
#include "app/session/stimulus_builder.h"
#include "app/tasks/warnings/checked_protocol.h"
#include "protocols/file/diagnostic.h"

namespace asperity {

/// `warnings_about_arrangements`, `warnings_about_forces`, `warnings_about_bands`, `warnings_about_slew`,
/// `warnings_about_indentation` and `warnings_about_observer`. Without a study those that need no
/// file (StimulusBuilder::can_make). `course` is that of the forces and then of the slew, which take nearly
/// all of the time; a stop also takes effect between two of the functions. Errors: as StimulusBuilder; none where the files have
/// been checked before.
std::vector<Diagnostic> warnings_about_stimuli(const CheckedProtocol& checked,
                                               StimulusBuilder& builder,
                                               const StimuliCourse& course = {});

}  // namespace asperity
