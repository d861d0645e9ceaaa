// The kind "matching".

#pragma once

#include "protocols/kinds/experiment_kind.h"

namespace asperity {

/// Several felt textures are assigned to as many pictures. Correct is the picture of the texture felt.
const ExperimentKind& matching_kind();

}  // namespace asperity
