// Makes figures of confusion matrices.

#pragma once

#include <vector>

#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/outcome/figure.h"
#include "app/findings/outcome/found_numbers.h"

namespace asperity {

/// Stimuli in rows, responses in columns: counts as numbers, proportions of a row as shades.
Figure confusion_figure(const FoundNumbers& found);
/// The same of a table of confusions (ConfusionTally).
std::vector<Figure> confusion_figures(const ResultTable& table, const AnalysisOutcome& outcome);

}  // namespace asperity
