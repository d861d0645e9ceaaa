// Makes the figures of times: responses, contact, and the course over the trials.

#pragma once

#include "app/findings/outcome/figure.h"
#include "app/findings/outcome/found_numbers.h"

namespace asperity {

/// Geometric means of response times by condition, with single participants behind them.
Figure response_times_figure(const FoundNumbers& found);

/// Medians of contact times by condition with their quartiles, from the findings of the exploration.
Figure contact_times_figure(const FoundNumbers& found);

/// Response times, and proportions correct, by range of trials: the mean over participants and a line for each.
Figure times_over_trials_figure(const FoundNumbers& found);
Figure correct_over_trials_figure(const FoundNumbers& found);

}  // namespace asperity
