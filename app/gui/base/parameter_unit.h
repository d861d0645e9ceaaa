// Declares the units in which windows show the parameters of force models.

#pragma once

#include "protocols/shapes/shape.h"
#include "stimuli/properties/parameter.h"

namespace asperity {

/// µm or mm for metres, mm/s, degrees; otherwise the unit of the parameter. Parameters without a unit have none.
DisplayUnit display_unit_of(const Parameter& parameter);

}  // namespace asperity
