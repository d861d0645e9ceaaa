// Makes the figure of estimates by stimulus.

#pragma once

#include <string>

#include "analysis/words/phrase.h"
#include "app/findings/outcome/figure.h"
#include "app/findings/outcome/found_numbers.h"

namespace asperity {

/// Estimates by stimulus: over the predictor on logarithmic axes with the power functions, a series per condition, or
/// without a predictor in rows. `predictor`: its name. `unit`: of it, if the name does not state it; lengths are drawn in
/// millimetres.
Figure stimulus_estimates_figure(const FoundNumbers& found, const Phrase& predictor,
                                 const std::string& unit);

}  // namespace asperity
