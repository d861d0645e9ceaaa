// Prepares a recorded attempt for rendering it again.

#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "app/session/stimulus_builder.h"
#include "protocols/plan/plan.h"
#include "renderers/servo/tick_record.h"
#include "results_schema/study.h"

namespace asperity {

/// "session 2 of participant P01"
std::string session_name(const SessionRow& session);

/// One surface of a recorded attempt and its stimulus, as stored.
struct RecordedSurface {
  PresentationRow row{};
  PreparedStimulus stimulus{};  ///< seed included
};

struct RecordedAttempt {
  AttemptRow row{};
  SessionRow session{};
  Trial trial{};
  double rate_Hz = 1000.0;
  std::vector<TickRecord> records{};
  std::vector<RecordedSurface> surfaces{};
};

/// Makes plans from the stored protocols, seeds, rows and responses of sessions; each protocol is read
/// once.
///
/// Threads: one at a time, as for the study.
class PlansOfSessions final {
 public:
  /// Both must outlive this object.
  PlansOfSessions(const Study& study, const ModelRegistry& models);

  /// Errors: ProtocolError or std::runtime_error when the plan made by this program differs from
  /// the stored one in any column.
  Plan of(const SessionRow& session);
  /// Errors: ProtocolError.
  const Protocol& protocol_of(const SessionRow& session);
  /// Whether the levels of its plan, which has been made, are those that an external program stated.
  bool has_stated_levels(const SessionRow& session) const;

 private:
  const Study& study_;
  std::vector<ModelDeclaration> declarations_{};
  std::map<std::int64_t, Protocol> protocols_{};
};

/// The plan of one session.
Plan plan_of(const Study& study, const SessionRow& session, const ModelRegistry& models);

/// Reads the recording of an attempt, and builds its stimuli with the stored parameters (which were
/// completed and matched at the time, and are not computed again).
///
/// Threads: any, with a builder that they share.
///
/// Errors: std::runtime_error or ResultsError naming what is missing.
RecordedAttempt recorded_attempt(const std::filesystem::path& study_folder,
                                 const SessionRow& session, const Trial& trial,
                                 const AttemptRow& attempt, StimulusBuilder& builder);
/// The same for one attempt of a study, whose session and plan it reads. Errors: also those of plan_of.
RecordedAttempt recorded_attempt(const Study& study, const AttemptRow& attempt,
                                 StimulusBuilder& builder);

/// The recorded motion of the hand on one surface, and the forces that it receives there again.
struct ReplayedSurface {
  std::vector<TickRecord> records{};
  std::vector<RenderedTick>
      ticks{};  ///< one per record; those without TickFlag::presenting are not rendered
};

/// Replays the attempt with this model and these inputs for the surface at `position`, from 1. Side by side the other
/// patches are those of the attempt.
///
/// Errors: std::invalid_argument for inputs that the model refuses.
ReplayedSurface replay_surface(const RecordedAttempt& attempt, int position,
                               const ForceModel& model, const RendererInputs& inputs);

/// "PARTICIPANT/SESSION/TRIAL/ATTEMPT".
std::string natural_key(const SessionRow& session, const AttemptRow& attempt);

/// The specified attempt: "PARTICIPANT/SESSION/TRIAL/ATTEMPT", or the number of its row in the
/// exported attempts.tsv (counted from 1).
///
/// Errors: std::runtime_error that lists what is stored.
AttemptRow find_attempt(const Study& study, const std::string& what);

}  // namespace asperity
