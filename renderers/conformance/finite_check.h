// The check that all numbers of a force model are finite.

#pragma once

#include "renderers/conformance/conformance.h"

namespace asperity {

/// `finite` of the conformance suite. `inputs` as for the other checks. When a stop is requested, it ends with what it has found.
ConformanceCheck finite_check(const ForceModel& model, const RendererInputs& inputs,
                              const ConformanceCourse& course);

}  // namespace asperity
