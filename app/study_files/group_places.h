// The places of participants in the order in which studies assigned them to groups.

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "results_schema/rows.h"

namespace asperity {

class Study;

/// The place of a participant in the study that assigned the group: the study itself or, for a session that was merged into it,
/// the one in which the session was run.
struct GroupPlace {
  const SessionRow* session = nullptr;
  /// The participant's first session there with the same protocol name and mode, whose place is that of the participant.
  const SessionRow* first = nullptr;
  std::string study{};  ///< SessionOrigin::key; empty for this study
  /// Participants of the same protocol name and mode to whom that study had assigned a group before, without those whose data are
  /// deleted.
  std::size_t before = 0;
  std::optional<int>
      dealt{};  ///< the place in the whole study, from 1, if it is divided among stations
};

/// Of every session with a group, except those of simulations, which follow the numbers of virtual participants. By study, in the
/// order of assignment. They refer to `sessions`. Errors: ResultsError.
std::vector<GroupPlace> group_places(const Study& study, const std::vector<SessionRow>& sessions);

}  // namespace asperity
