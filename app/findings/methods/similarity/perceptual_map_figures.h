// Makes the figures of rated dissimilarities.

#pragma once

#include "app/findings/outcome/figure.h"
#include "app/findings/outcome/found_numbers.h"

namespace asperity {

// Of rated dissimilarities, from the findings of the family `similarity`.

Figure configuration_figure(const FoundNumbers& found);
/// The Shepard diagram.
Figure shepard_figure(const FoundNumbers& found);
/// Stress by the number of dimensions.
Figure stress_figure(const FoundNumbers& found);
/// The weights of the participants.
Figure weights_figure(const FoundNumbers& found);

}  // namespace asperity
