// Simulates the responses of all participants of one study.

#pragma once

#include <vector>

#include "analysis/numbers/random.h"
#include "app/findings/gathering/gathered_answers.h"
#include "app/power/power_tables.h"

namespace asperity {

/// The responses of so many participants in all their sessions, as an analysis gathers them from a study. Participants are assigned
/// to rows of counterbalancing and to groups as those of `asperity simulate` (allocation_in_turn). A participant is the same
/// however many others there are.
std::vector<GatheredAnswers> simulated_study(const PowerTables& tables, int participants,
                                             const Random& of_study);

}  // namespace asperity
