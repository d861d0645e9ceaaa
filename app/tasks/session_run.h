// Runs one session on a rig, new or resumed, of a person or a virtual participant.

#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>

#include "app/session/conductor.h"
#include "app/session/rehearsal/rehearsed_device.h"
#include "app/study_files/program.h"
#include "app/tasks/unfinished_session.h"

namespace asperity {

/// The settings of a session, apart from its rig.
struct SessionRun {
  ParticipantRow participant{};
  std::optional<SessionRow> unfinished{};  ///< the session to resume; otherwise a new one is begun
  std::optional<LateResume> late{};        ///< it is older than the protocol's maximum
  std::string late_reason{};               ///< why it is resumed nevertheless
  SessionMode mode = SessionMode::run;
  std::uint64_t seed = 0;
  std::optional<int> counterbalance_row{};
  std::optional<std::string> group{};  ///< as SessionConditions::group
  std::string consent{};               ///< the statement that the participant agreed to, as read
  std::optional<std::string> consent_utc{};
  bool mirrored = false;  ///< of a new session
  /// The profile of a participant's device, and the parts of the plan that exceed it: stored with
  /// the session.
  RehearsedDevice device{};
  bool record = true;
  /// States the levels of the procedure `external`.
  std::optional<ExternalProgram> level_program{};
};

/// Runs the session. `person` is null for a virtual participant, who then answers as the protocol's
/// observer does. The caller holds the participant's lock. `stop` requests the end after the
/// current trial. Errors: PhrasedError, before anything is stored, for a device that the protocol does not accept and for
/// an external program that is missing or cannot be used, unless every level of a resumed session is stored.
SessionEnd run_on_rig(Study& study, const Protocol& protocol, StimulusBuilder& builder,
                      const ProgramIdentity& program, const SessionRun& session_run, Rig& rig,
                      Respondent* person, const std::stop_token& stop,
                      const std::function<void(const AttemptDone&)>& done,
                      const SessionLinks& links = {});

}  // namespace asperity
