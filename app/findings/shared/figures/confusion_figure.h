// Makes figures of confusion matrices.

#pragma once

#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/outcome/figure.h"
#include "app/findings/outcome/found_numbers.h"

namespace asperity {

/// Stimuli in rows, responses in columns: counts as numbers, proportions of a row as shades.
Figure confusion_figure(const FoundNumbers& found);
Figure confusion_figure(const ResultTable& table);

}  // namespace asperity
