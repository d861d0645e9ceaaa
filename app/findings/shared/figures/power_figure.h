// Makes the figure of power by sample size, in closed form.

#pragma once

#include "app/findings/outcome/figure.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/findings/tidy/tidy_families.h"

namespace asperity {

/// Power by sample size, a curve per plan; plans without a second size a row each.
Figure power_figure(const TidyInput& input, const FoundNumbers& found);

}  // namespace asperity
