// The bias of a mean threshold that leaves out thresholds on one side of the presented levels.

#pragma once

#include <string>
#include <vector>

#include "analysis/finding.h"
#include "app/findings/study/discrimination_results.h"
#include "app/words/phrase.h"

namespace asperity {

/// The answer, and after it how many thresholds the mean leaves out because they are below, or above, the presented levels,
/// and the direction of the bias of the mean; and how many could not be estimated, with the reasons.
Phrase with_left_out_thresholds(Phrase answer, const DiscriminationResults& results);

/// The note below the means, and after it for each measure how many thresholds its means leave out and the direction of the
/// bias.
Phrase with_left_out_means(Phrase note, const std::vector<DiscriminationResults>& all);

/// " The mean JND is too high, because it does not include two of 6 JNDs, which are below the presented levels.": the same of
/// the thresholds of this quantity, for a paper; empty where there is no mean.
std::string bias_sentences(const std::vector<Finding>& findings, const std::string& quantity,
                           const std::string& measure);

}  // namespace asperity
