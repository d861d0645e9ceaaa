// A recorded attempt, made ready to be rendered again.

#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "app/session/stimulus_builder.h"
#include "protocols/plan/plan.h"
#include "renderers/servo/tick_record.h"
#include "results_schema/study.h"

namespace asperity {

/// One surface of a recorded attempt and the stimulus that was felt, as it was stored.
struct RecordedSurface {
  PresentationRow row{};
  PreparedStimulus stimulus{};  ///< seed included
};

struct RecordedAttempt {
  AttemptRow row{};
  SessionRow session{};
  double rate_Hz = 1000.0;
  std::vector<TickRecord> records{};
  std::vector<RecordedSurface> surfaces{};
};

/// The plans that the stored protocols, seeds and rows of sessions give; each protocol is read once.
///
/// Threads: one at a time, as the study.
class PlansOfSessions final {
 public:
  /// Both are borrowed.
  PlansOfSessions(const Study& study, const ModelRegistry& models);

  /// Errors: ProtocolError or std::runtime_error when this program does not make the plan that was
  /// stored, in whatever column.
  Plan of(const SessionRow& session);

 private:
  const Study& study_;
  std::vector<ModelDeclaration> declarations_{};
  std::map<std::int64_t, Protocol> protocols_{};
};

/// Of one session.
Plan plan_of(const Study& study, const SessionRow& session, const ModelRegistry& models);

/// Reads the recording of an attempt, and builds its stimuli with the parameters that are stored of
/// it (completed and matched then, not anew).
///
/// Errors: std::runtime_error or ResultsError naming what is missing.
RecordedAttempt recorded_attempt(const Study& study, const SessionRow& session, const Trial& trial,
                                 const AttemptRow& attempt, StimulusBuilder& builder);

/// "PARTICIPANT/SESSION/TRIAL/ATTEMPT".
std::string natural_key(const SessionRow& session, const AttemptRow& attempt);

/// The attempt that a person means: "PARTICIPANT/SESSION/TRIAL/ATTEMPT", or the number of its row
/// in the exported attempts.tsv (counted from 1).
///
/// Errors: std::runtime_error saying what is there.
AttemptRow find_attempt(const Study& study, const std::string& what);

}  // namespace asperity
