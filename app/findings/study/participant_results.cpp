// Counts errors in catch trials, and divides normalised by raw estimates in the table that the analysis of magnitudes makes.

#include "app/findings/study/participant_results.h"

#include <algorithm>
#include <set>
#include <variant>
#include <vector>

#include "app/findings/methods/discrimination/catch/catch_exclusions.h"
#include "app/findings/outcome/columns.h"
#include "app/findings/outcome/study_analysis.h"
#include "app/findings/shared/estimates.h"
#include "protocols/file/stored_protocol.h"
#include "protocols/kinds/experiment_kind.h"

namespace asperity {

namespace {

bool asks_for_numbers(const ExperimentKind* kind) {
  return kind != nullptr && std::holds_alternative<NumberForm>(kind->form);
}

bool has_results(const ProtocolRow& row) {
  const Protocol specified = stored_protocol(row.source).protocol;
  const std::vector<const ExperimentKind*> kinds = kinds_of(specified);
  return specified.analysis.exclude || asks_for_numbers(find_kind(row.kind)) ||
         std::any_of(kinds.begin(), kinds.end(), asks_for_numbers);
}

}  // namespace

ParticipantResults::ParticipantResults(const Study& study, const std::stop_token& stop) {
  std::set<std::string> names{};
  for (const ProtocolRow& protocol : study.protocols()) {
    if (has_results(protocol)) names.insert(protocol.name);
  }
  for (const std::string& name : names) {
    for (const GatheredAnswers& gathered : gather_answers(study, name, stop)) {
      if (stop.stop_requested()) return;
      if (asks_for_numbers(find_kind(gathered.kind))) add_own_scales(gathered);
      if (!gathered.declared.exclude) continue;
      for (const CatchErrors& errors : catch_errors(gathered)) {
        results_[{gathered.protocol, gathered.version, gathered.group, errors.participant}]
            .is_excluded_by_catch = is_excluded(*gathered.declared.exclude, errors);
      }
    }
  }
}

void ParticipantResults::add_own_scales(const GatheredAnswers& gathered) {
  AnalysisOutcome outcome{};
  find_analysis(gathered.kind)->analyze(gathered, outcome);
  for (const ResultTable& table : outcome.tables) {
    if (table.name != kEstimatesOfPersons) continue;
    for (const ResultRow& cells : table.rows) {
      const RowReader row(table, cells);
      const std::string person = row.text(columns::kPerson);
      const auto raw = row.number(kRawEstimate);
      const auto normalised = row.number(kNormalisedEstimate);
      if (person.empty() || !raw || !normalised) continue;
      std::optional<double>& scale =
          results_[{gathered.protocol, gathered.version, gathered.group, person}].own_scale;
      if (!scale) scale = *normalised / *raw;
    }
  }
}

ParticipantResult ParticipantResults::of(const ParticipantRow& participant,
                                         const SessionRow& session,
                                         const ProtocolRow& protocol) const {
  const auto found = results_.find(
      {protocol.name, protocol.version, group_of(participant, session), participant.label});
  return found == results_.end() ? ParticipantResult{} : found->second;
}

}  // namespace asperity
