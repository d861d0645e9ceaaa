// Makes figures of proportions with their intervals, a row each.

#pragma once

#include <vector>

#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/outcome/figure.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/findings/tidy/tidy_families.h"

namespace asperity {

// Proportions with intervals, a row each, and chance as a line; where it differs between rows, as a mark in each. Single
// participants are shown behind means over participants.

/// The means over participants that belong to a table of proportions.
struct MeansOfShares {
  const char* table = "";     ///< made by add_persons; drawn if the outcome has it
  const char* analysis = "";  ///< of the participants' own proportions
};
/// Of a table made by add_shares.
Figure share_forest(const ResultTable& table);
Figure share_forest(const ResultTable& table, const AnalysisOutcome& outcome,
                    const MeansOfShares& means);
/// Of a table made by add_persons. `analysis` as in MeansOfShares; `shares`: the table of all proportions, with their chance
/// level.
Figure person_forest(const ResultTable& table, const AnalysisOutcome& outcome, const char* analysis,
                     const char* shares);
Figure proportion_forest(const TidyInput& input, const FoundNumbers& found);
Figure selection_forest(const FoundNumbers& found);
Figure matching_forest(const FoundNumbers& found);
Figure recognition_forest(const FoundNumbers& found);
std::vector<Figure> seedpaper_forests(const FoundNumbers& found);

}  // namespace asperity
