// Makes the figure of ratings on several scales.

#pragma once

#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/outcome/figure.h"

namespace asperity {

/// The ends of a scale, as labelled for participants.
inline const ResultColumn kLowLabel{.id = "low_label",
                                    .heading = phrase("AnalysisWords", "label of the minimum")};
inline const ResultColumn kHighLabel{.id = "high_label",
                                     .heading = phrase("AnalysisWords", "label of the maximum")};

/// Mean ratings of the items on several scales, a row per scale and a line per item. `shown`: the
/// table of the ends and ranges of the scales; may be null.
Figure profile_figure(const ResultTable& ratings, const ResultTable* shown);

}  // namespace asperity
