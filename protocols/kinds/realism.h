// The standard of realism, for the kinds whose surfaces can be compared with one.

#pragma once

#include "protocols/kinds/experiment_kind.h"

namespace asperity {

/// Where the standard is a physical sample, the experimenter needs to know which one to place.
void check_prompt_for_sample(const BlockOfKind& checked, ProblemSink& problems);

/// The surfaces of the trial are renderings of one texture, for which there is a standard.
void check_surfaces_with_standard(const BlockOfKind& checked, const Trial& trial,
                                  ProblemSink& problems);

}  // namespace asperity
