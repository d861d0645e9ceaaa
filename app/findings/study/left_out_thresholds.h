// The bias of a mean threshold that leaves out thresholds on one side of the presented levels.

#pragma once

#include <string>
#include <vector>

#include "analysis/finding.h"
#include "app/findings/study/discrimination_results.h"
#include "app/words/phrase.h"

namespace asperity {

/// The answer, and after it how many thresholds the mean leaves out because they are below, or above, the presented levels,
/// and the direction of the bias of the mean, which is unknown if they are on both sides; and how many could not be estimated,
/// with the reasons.
Phrase with_left_out_thresholds(Phrase answer, const DiscriminationResults& results);

/// The note below the means, and after it the same of each measure.
Phrase with_left_out_means(Phrase note, const std::vector<DiscriminationResults>& all);

/// " Of the 6 JNDs, the mean does not include 2 below the presented levels; a mean without such thresholds is too high.": the same
/// of the thresholds of this quantity, for a paper; empty where there is no mean.
std::string bias_sentence(const std::vector<Finding>& findings, const std::string& quantity,
                          const std::string& measure);

}  // namespace asperity
