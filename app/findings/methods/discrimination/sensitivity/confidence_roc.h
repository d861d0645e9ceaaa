// The receiver operating characteristic (ROC) of the responses of a discrimination and the ratings of their confidence.

#pragma once

#include <vector>

#include "app/findings/methods/discrimination/thresholds/discrimination_results.h"

namespace asperity {

/// The table, and the analysis of its findings.
inline constexpr const char* kConfidenceRoc = "confidence_roc";
/// In place of the label of a participant, the row of the responses of all participants. Labels have no blanks.
inline constexpr const char* kAllParticipants = "all participants";

/// Response and confidence together are ordered categories, from "no" with the greatest confidence to "yes" with the greatest
/// confidence. Noise and signal are
///
///   two alternatives    trials with the comparison as surface B and as surface A, "yes" being the choice of A
///   yes/no              trials without a signal, of the condition, and with the signal at a level; "yes"
///   same–different      trials with equal surfaces, of the condition, and with different ones at a level; "different"
///
/// Adds the findings of the family `roc` for every condition and level (key "CONDITION|LEVEL"), over all participants, with the
/// means of their areas, and for every participant ("CONDITION|LEVEL|PARTICIPANT"); their table and a question.
/// Nothing without ratings, and for levels that a procedure chose.
void add_confidence_roc(const GatheredAnswers& gathered,
                        const std::vector<DiscriminationResults>& all, AnalysisOutcome& outcome);

}  // namespace asperity
