// The kind "recognition".

#pragma once

#include "protocols/kinds/experiment_kind.h"

namespace asperity {

/// One felt texture is recognised among pictures: a choice, correct by a factor of the design.
const ExperimentKind& recognition_kind();

}  // namespace asperity
