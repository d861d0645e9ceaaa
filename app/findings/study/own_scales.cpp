// Divides normalised by raw estimates in the tables that the analysis of each protocol makes.

#include "app/findings/study/own_scales.h"

#include <algorithm>
#include <cstdint>
#include <set>
#include <variant>

#include "app/findings/outcome/columns.h"
#include "app/findings/shared/estimates.h"
#include "app/findings/study/analyze_study.h"
#include "protocols/file/stored_protocol.h"
#include "protocols/kinds/experiment_kind.h"

namespace asperity {

OwnScales::OwnScales(const Study& study, const std::stop_token& stop) {
  std::set<std::int64_t> with_sessions{};
  for (const SessionRow& session : study.sessions()) with_sessions.insert(session.protocol_id);
  std::set<std::string> names{};
  for (const ProtocolRow& protocol : study.protocols()) {
    std::vector<const ExperimentKind*> kinds = kinds_of(stored_protocol(protocol.source).protocol);
    kinds.push_back(find_kind(protocol.kind));
    const bool has_estimates = std::any_of(kinds.begin(), kinds.end(), [](const auto* kind) {
      return kind != nullptr && std::holds_alternative<NumberForm>(kind->form);
    });
    if (has_estimates && with_sessions.contains(protocol.id)) names.insert(protocol.name);
  }
  for (const std::string& name : names) {
    for (const AnalysisOutcome& outcome : analyze_study(study, name, stop)) {
      for (const ResultTable& table : outcome.tables) {
        if (table.name != kEstimatesOfPersons) continue;
        for (const ResultRow& cells : table.rows) {
          const RowReader row(table, cells);
          const std::string person = row.text(columns::kPerson);
          const auto raw = row.number(kRawEstimate);
          const auto normalised = row.number(kNormalisedEstimate);
          if (person.empty() || !raw || !normalised) continue;
          factors_.try_emplace({outcome.protocol, outcome.version, outcome.group, person},
                               *normalised / *raw);
        }
      }
    }
  }
}

std::optional<double> OwnScales::of(const ParticipantRow& participant, const SessionRow& session,
                                    const ProtocolRow& protocol) const {
  const auto found = factors_.find(
      {protocol.name, protocol.version, group_of(participant, session), participant.label});
  if (found == factors_.end()) return {};
  return found->second;
}

}  // namespace asperity
