// The kind "magnitude".

#pragma once

#include "protocols/kinds/experiment_kind.h"

namespace asperity {

/// A number states how rough one felt surface is (magnitude estimation). No response is correct or incorrect.
const ExperimentKind& magnitude_kind();

}  // namespace asperity
