// Evaluates the stimuli that plug-ins render.

#pragma once

#include <string>
#include <vector>

#include "app/session/stimulus_builder.h"
#include "app/tasks/warnings/checked_protocol.h"
#include "protocols/file/diagnostic.h"

namespace asperity {

/// The stimuli of loaded plug-ins that would fail in a session: each is made once with the values of the protocol, and stroked
/// across the surface and beyond its border, above it and up to 2 mm in it. The conformance suite, which every plug-in has
/// passed, does not know these values. Stimuli whose files are not available are left out.
std::vector<Diagnostic> problems_of_plugin_stimuli(const CheckedProtocol& checked,
                                                   StimulusBuilder& builder);

}  // namespace asperity
