// Compares the stored groups and counterbalancing rows of a study that is divided among stations with the places of its participants.

#pragma once

#include <string>
#include <vector>

#include "app/records/recorded_attempt.h"
#include "results_schema/study.h"

namespace asperity {

/// What contradicts the places that are dealt to stations (allocations_in_turn), as sentences: another group, or another row of
/// the counterbalancing, than that of the place of the session. Later sessions of a participant have those of the first one, and
/// are not compared, because the protocol may have a new version.
std::vector<std::string> place_problems(const Study& study, PlansOfSessions& plans);

/// In a merged study, the places that participants of different stations have, as warnings: a sentence for each protocol that
/// names the places and the participants. A participant has a place with an open or completed session, except after a
/// withdrawal. Within one station a place can be that of two participants, of whom one dropped out and came back.
std::vector<std::string> shared_places(const Study& study);

}  // namespace asperity
