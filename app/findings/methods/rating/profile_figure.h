// Makes the figure of ratings on several scales.

#pragma once

#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/outcome/figure.h"

namespace asperity {

/// Mean ratings of the items on several scales, a row per scale and a line per item. `shown`: the
/// table of the ends and ranges of the scales; may be null.
Figure profile_figure(const NamedTable& ratings, const NamedTable* shown);

}  // namespace asperity
