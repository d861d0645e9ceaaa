// The methods and estimates of a discrimination, in sentences of a text for a paper.

#pragma once

#include <string>
#include <vector>

#include "app/findings/outcome/analysis_outcome.h"
#include "protocols/design/protocol.h"

namespace asperity {

/// The main blocks of this kind that vary a parameter relative to a stated standard.
std::vector<const Protocol::Block*> discrimination_blocks(const Protocol& protocol);
/// Whether one response is correct.
bool asks_for_performance(const Protocol::Block& block);

/// The functions that were fitted and their intervals, and how d′ and the ROC were computed. Sentences on the response
/// "cannot tell", on d′ and on the ROC depend on what the outcome contains; without findings there are none.
std::string paper_fit_of_discrimination(const Protocol& protocol, const AnalysisOutcome& outcome);

/// The rate of the responses "cannot tell", the mean d′ at each level, and A_z and d_a of the ratings of confidence, as far as
/// the outcome contains them; each sentence begins with a blank.
std::string sensitivity_sentences(const AnalysisOutcome& outcome);

}  // namespace asperity
