// States how the responses to the anchors of a session changed, for its end.

#pragma once

#include <span>
#include <vector>

#include "analysis/words/phrase.h"
#include "protocols/plan/plan.h"
#include "results_schema/rows.h"

namespace asperity {

/// A sentence for each run of a block and each question with responses to at least two anchors, in the order of the
/// session: "Anchors of block 3 (main), question rough: 12 → 11 → 9; last/first: 0.75." Of ratings the difference of the
/// last and the first response is stated; choices are shown by their labels, or as correct or incorrect. Contains no
/// names of stimuli. Invalid attempts are left out.
std::vector<Phrase> anchor_summary(const Plan& plan, std::span<const AttemptRow> attempts);

}  // namespace asperity
