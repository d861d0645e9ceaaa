// What a stored attempt means for the procedure that chose the level of its trial.

#pragma once

#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "app/session/levels/supplied_steps.h"
#include "protocols/design/trial.h"
#include "protocols/plan/course.h"
#include "protocols/procedures/level_answer.h"
#include "results_schema/rows.h"

namespace asperity {

/// The outcome of a trial of a track, from the attempt that completed it.
///
/// The level is the delivered one: the value of the varied parameter with which the surface was
/// rendered. A skipped trial does not count, and neither does a missed deadline of the judged question,
/// unless the protocol specifies that it is an incorrect response.
TrialOutcome outcome_of(const Protocol& protocol, const Trial& trial, const AttemptRow& attempt);
/// The same as the answer of a procedure: with the level as the levels are stated (Dimension).
std::optional<LevelAnswer> level_answer_of(const Protocol& protocol, const Trial& trial,
                                           const AttemptRow& attempt);

/// Trial and attempt.
using AttemptNumbers = std::set<std::pair<int, int>>;
/// The attempts that were invalidated after they had completed their trials.
AttemptNumbers set_aside_in(const std::vector<DecisionRow>& decisions);

/// Continues a course with the stored attempts of its session, in the order of the trials, and with the stored steps of an
/// external program where it requests them.
///
/// The outcome of a trial is that of the first attempt that completed it, even if this attempt was
/// invalidated later: the following levels were presented because of it. Whatever is decided later
/// changes the analysis and not the levels that were presented.
///
/// Errors: as `SuppliedSteps::supply`; std::runtime_error where more steps are stored than the course requests.
void advance_through(Course& course, const Protocol& protocol,
                     const std::vector<AttemptRow>& attempts, const AttemptNumbers& set_aside,
                     SuppliedSteps supplied);

}  // namespace asperity
