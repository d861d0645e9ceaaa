// Makes figures of means: ratings of items, and the cells of an analysis of variance.

#pragma once

#include <string>

#include "app/findings/outcome/figure.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/findings/tidy/tidy_families.h"

namespace asperity {

/// Mean scores with intervals, a row per item.
Figure rating_figure(const FoundNumbers& found);

/// Means of the cells, the factor with the most levels along the axis and a line for each
/// combination of the others. `unit`: of levels that are numbers.
Figure interaction_figure(const TidyInput& input, const FoundNumbers& found,
                          const std::string& unit);

}  // namespace asperity
