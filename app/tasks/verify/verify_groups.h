// Compares the stored groups of participants with the sequence from which their protocol assigns them.

#pragma once

#include <string>
#include <vector>

#include "app/records/recorded_attempt.h"
#include "results_schema/study.h"

namespace asperity {

/// What contradicts the permuted blocks of a protocol (permuted_group) in the groups of participants, as sentences: another
/// group than that of the participant's place in the sequence, and another group than in the participant's first session.
///
/// The place is the number of participants of the same protocol and mode who had a group before. Participants whose data
/// were deleted are no longer among them, so that with n deleted participants each of n + 1 places is possible. Virtual
/// participants of a simulation are assigned by their number, and their groups are not compared; nor are those of
/// participants with a dealt place (verify_places.h). A participant of a merged study has the place in the study from which
/// the first session was merged.
std::vector<std::string> group_problems(const Study& study, PlansOfSessions& plans);

}  // namespace asperity
