// The kind "rating".

#pragma once

#include "protocols/kinds/experiment_kind.h"

namespace asperity {

/// One surface is felt and rated on one or more scales [Osgood 1957]. Scales can also
/// accompany the question of another kind.
const ExperimentKind& rating_kind();

}  // namespace asperity
