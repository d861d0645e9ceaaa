// The reasons why a threshold of a discrimination cannot be estimated.

#pragma once

#include <string>

#include "analysis/finding.h"
#include "app/findings/study/discrimination_tasks.h"

namespace asperity {

/// Why there is no number: a word for programs and a sentence.
struct WhyNoThreshold {
  std::string word{};
  std::string sentence{};
};

WhyNoThreshold threshold_outside_levels();
WhyNoThreshold equality_outside_levels();
WhyNoThreshold quartiles_outside_levels();
/// The fitted slope is at the bound of the fit, and at a limit that is set for procedures.
WhyNoThreshold slope_at_bound();
WhyNoThreshold slope_at_limit();
/// `status`: of the family `psyfit`; null without one.
WhyNoThreshold why_not_fitted(const DiscriminationTask& task, const Finding* status);

}  // namespace asperity
