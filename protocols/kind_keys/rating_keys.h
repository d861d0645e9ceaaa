// The keys that only a rating has.

#pragma once

#include "protocols/kind_keys/rating.h"
#include "protocols/shapes/key.h"

namespace asperity {

extern const KeyTableOf<ConstructDeclaration> kConstructTable;

}  // namespace asperity
