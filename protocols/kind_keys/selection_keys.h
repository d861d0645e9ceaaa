// The keys that a selection has, and a paired comparison of realism.

#pragma once

#include "protocols/kind_keys/selection.h"
#include "protocols/shapes/common_shapes.h"
#include "protocols/shapes/keys_of.h"

namespace asperity {

inline constexpr auto kStandards = words_of<RealismStandard>(
    {{"photograph", RealismStandard::photograph, "the texture's picture"},
     {"physical_sample", RealismStandard::physical_sample, "the coded sample"},
     {"memory", RealismStandard::memory, "the participant's own idea of the material"}});

}  // namespace asperity
