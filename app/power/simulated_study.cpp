// Splits random numbers by participant and session, and gathers the responses as from a store.

#include "app/power/simulated_study.h"

#include <cstdint>
#include <string>
#include <utility>

#include "app/power/simulated_session.h"
#include "protocols/plan/groups.h"

namespace asperity {

namespace {

/// With leading zeros, so that participants are in the order of their labels.
std::string label_of_participant(int number) {
  std::string digits = std::to_string(number + 1);
  if (digits.size() < 6) digits.insert(0, 6 - digits.size(), '0');
  return "p" + digits;
}

}  // namespace

std::vector<GatheredAnswers> simulated_study(const PowerTables& tables, int participants,
                                             const Random& of_study) {
  const Protocol& protocol = tables.protocol;
  SessionGathering gathering(tables.gathered);
  for (int number = 0; number < participants; ++number) {
    const ParticipantRow person{.label = label_of_participant(number),
                                .is_virtual = true,
                                .sex = number % 2 == 0 ? "F" : "M"};
    const Random of_participant =
        of_study.split("participant").split(static_cast<std::uint64_t>(number));
    const Allocation in_turn = allocation_in_turn(protocol, number);
    for (int session = 1; session <= protocol.sessions; ++session) {
      const Random of_session =
          of_participant.split("session").split(static_cast<std::uint64_t>(session));
      Allocation allocation = in_turn;
      allocation.seed = Random(of_session).bits();
      SessionRow row{.participant = person.label,
                     .session = session,
                     .protocol_id = tables.gathered.row.id,
                     .mode = SessionMode::simulate,
                     .state = SessionState::completed};
      if (!allocation.group.empty()) row.group_level = allocation.group;
      gathering.add(person, row,
                    simulated_session({.tables = tables,
                                       .allocation = std::move(allocation),
                                       .of_study = of_study.split("textures"),
                                       .of_participant = of_participant.split("differences"),
                                       .of_session = of_session}));
    }
  }
  return std::move(gathering).finish();
}

}  // namespace asperity
