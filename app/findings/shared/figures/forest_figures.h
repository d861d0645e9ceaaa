// Makes figures of proportions with their intervals, a row each.

#pragma once

#include <vector>

#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/outcome/figure.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/findings/tidy/tidy_families.h"

namespace asperity {

/// Proportions with intervals, a row each, and chance as a line; where it differs between rows, as
/// a mark in each. Single participants are shown behind means over participants.
std::vector<Figure> table_forests(const AnalysisOutcome& outcome);
Figure proportion_forest(const TidyInput& input, const FoundNumbers& found);
Figure selection_forest(const FoundNumbers& found);
Figure matching_forest(const FoundNumbers& found);
Figure recognition_forest(const FoundNumbers& found);
std::vector<Figure> seedpaper_forests(const FoundNumbers& found);

}  // namespace asperity
