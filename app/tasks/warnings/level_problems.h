// Finds the levels of a varied parameter that give the same surface.

#pragma once

#include <string>
#include <vector>

#include "app/session/stimulus_builder.h"
#include "app/tasks/warnings/checked_protocol.h"
#include "protocols/file/diagnostic.h"

namespace asperity {

/// A problem for every block with two neighbouring levels that are the same value of the parameter, which is computed
/// with 12 significant digits.
std::vector<Diagnostic> problems_of_values(const Protocol& protocol, const std::string& file_name);

/// A problem for every block whose levels scale the heights of a file in which all heights are the same.
///
/// The steps in which a file stores heights, q = (h_max − h_min)/65535, do not limit the levels. The force models multiply the
/// stored heights, in double precision and at every tick: a level s changes every height h to s·h, and a step of levels
/// far below q/h still changes each height by its exact proportion. The rounding of the file, at most q/2, is scaled
/// with the relief, of which it is the same proportion at all levels.
///
/// The files have been checked before.
std::vector<Diagnostic> problems_of_scaled_heights(const CheckedProtocol& checked,
                                                   StimulusBuilder& builder);

}  // namespace asperity
