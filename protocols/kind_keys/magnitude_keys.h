// The keys of a magnitude estimation.

#pragma once

#include "protocols/kind_keys/magnitude.h"
#include "protocols/shapes/common_shapes.h"
#include "protocols/shapes/keys_of.h"

namespace asperity {

extern const KeyTableOf<EstimationDeclaration> kEstimationTable;
extern const KeyTableOf<EstimationModulus> kModulusTable;

/// Of a virtual participant, which also rates on scales by this power function.
inline constexpr auto kMagnitudeObserverKeys = keys_of(
    member_key<&MagnitudeObserver::exponent>("exponent", "Exponent",
                                             "Magnitude and rating: exponent of the power function "
                                             "from the judged quantity to the estimate.",
                                             NumberShape{.above = 0.0, .maximum = 10.0}));

}  // namespace asperity
