// Makes the biplot of principal components.

#pragma once

#include "app/findings/outcome/figure.h"
#include "app/findings/outcome/found_numbers.h"

namespace asperity {

/// Scores of items as points and loadings of scales as arrows, on the first two components.
Figure biplot_figure(const FoundNumbers& found);

}  // namespace asperity
