// The kind "paired_comparison".

#pragma once

#include "protocols/kinds/experiment_kind.h"

namespace asperity {

/// Two surfaces are felt, and the one that has more of an attribute, or is closer to a standard, is chosen
/// [Bradley 1952]. A tie can be an option.
const ExperimentKind& paired_comparison_kind();

}  // namespace asperity
