// Makes the figures of ratings on one or several scales.

#pragma once

#include <vector>

#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/outcome/figure.h"

namespace asperity {

/// The ends of a scale, as labelled for participants.
inline const ResultColumn kLowLabel{.id = "low_label",
                                    .heading = phrase("AnalysisWords", "label of the minimum")};
inline const ResultColumn kHighLabel{.id = "high_label",
                                     .heading = phrase("AnalysisWords", "label of the maximum")};

/// The table of the scales, as shown to participants.
inline constexpr const char* kScales = "scales";

/// Of the table of mean ratings, whose findings have its name: for one scale a row per item, for several a profile. It answers the
/// question about the last of them.
std::vector<Figure> rating_figures(const ResultTable& ratings, const AnalysisOutcome& outcome);

/// Mean ratings of the items on several scales, a row per scale and a line per item. `shown`: the
/// table of the ends and ranges of the scales; may be null.
Figure profile_figure(const ResultTable& ratings, const ResultTable* shown);

}  // namespace asperity
