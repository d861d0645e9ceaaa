// The reasons why a threshold of a discrimination cannot be estimated.

#pragma once

#include <string>

#include "analysis/numbers/finding.h"
#include "analysis/words/phrase.h"
#include "app/findings/methods/discrimination/thresholds/discrimination_tasks.h"

namespace asperity {

/// Why there is no number: a word for programs, and a sentence with the remedy. All displays of the
/// reason take the sentence from here.
struct WhyNoThreshold {
  std::string word{};
  Phrase sentence{};
};

/// The side of the presented levels on which a missing threshold lies.
enum class SideOfThreshold { unknown, below, above };
/// `threshold`: a finding without a number.
SideOfThreshold side_of_threshold(const Finding& threshold);

/// The fitted threshold of a performance is greater, or smaller, than all presented differences.
WhyNoThreshold threshold_above_levels();
WhyNoThreshold threshold_below_levels();
WhyNoThreshold equality_outside_levels();
WhyNoThreshold quartiles_outside_levels();
/// The fitted slope is at the bound of the fit, and at a limit that is set for procedures.
WhyNoThreshold slope_at_bound();
WhyNoThreshold slope_at_limit();
/// Much of the posterior probability is at an end of the prior.
WhyNoThreshold threshold_at_end_of_prior();
/// `status`: of the family `psyfit`; null without one.
WhyNoThreshold why_not_fitted(const DiscriminationTask& task, const Finding* status);

}  // namespace asperity
