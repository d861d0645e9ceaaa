// Runs one session of one participant.

#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "app/session/conductor.h"
#include "app/session/rehearsal/rehearsal_memory.h"
#include "app/session/rehearsal/rehearsed_device.h"
#include "app/session/session_links.h"
#include "app/tasks/label_notice.h"
#include "device/drivers.h"
#include "device/simulated_device.h"
#include "renderers/force/force_model.h"

namespace asperity {

enum class RunPacing { stepped, real_time };

struct RunInputs {
  std::filesystem::path protocol{};  ///< or its translation, for a session in another language
  std::filesystem::path study{};
  std::string participant{};
  std::uint64_t seed = 0;
  /// Of a new session, where the protocol has groups that the experimenter assigns; it may be left
  /// out when the participant has a session of the protocol.
  std::optional<std::string> group{};
  SessionMode mode = SessionMode::run;
  bool resume = false;  ///< resumes an unfinished session
  /// The session to resume, by its id in the store; otherwise the participant's latest.
  std::optional<std::int64_t> resumed_session{};
  /// Why it is resumed although it is older than the protocol's maximum
  /// (`resume.maximum_age_hours`).
  std::string late_reason{};
  bool is_virtual = false;
  RunPacing pacing = RunPacing::real_time;
  /// The device, as DriverRegistry::open names it; a virtual participant has the simulated one.
  std::string device = "simulated";
  DriverOptions driver_options{};       ///< options of that device's driver
  std::vector<ScriptedFault> faults{};  ///< of the simulated device
  /// But for its rate, which is the protocol's. A test on a busy machine sets longer times.
  ServoSettings servo{};
  /// Mirrors the workspace and the strokes left to right, for a left hand.
  bool mirrored = false;
  /// States the levels of the procedure `external`; required by a protocol that has it.
  std::optional<ExternalProgram> level_program{};
  /// A new participant who has already answered the protocol's questions (the label is
  /// `participant`); otherwise the respondent is asked.
  std::optional<ParticipantRow> new_person{};
  /// Where the contacts of two textured bodies are evaluated; absent: as the protocol states.
  std::optional<bool> on_gpu{};
  /// Results of earlier comparisons of the plan with this device; null: none.
  std::shared_ptr<RehearsalMemory> rehearsal{};
  /// Receives the progress of that comparison, 0 to 1, where it has to be made.
  std::function<void(double)> comparing{};
  /// Receives the parts of the plan that exceed a participant's device, before the session is
  /// rejected for them.
  std::function<void(const RehearsedDevice&)> rehearsed{};
  /// Called once the device is open and the protocol accepts it, before any question is asked.
  std::function<void(const Protocol&)> ready{};
  /// Called before `ready` if a resumed session has a different device than before, which its
  /// report will state.
  std::function<void(const Phrase& circumstance)> resumed{};
  /// Called before `ready` with what the study has under the label of a new session. Nothing is
  /// stored before it returns; it can wait for a confirmation, and throw RespondentGone.
  std::function<void(const LabelNotice&, const Wait&)> noticed{};
  /// The protocol's statement as the participant has read it and agreed to it; otherwise the respondent is asked.
  std::optional<std::string> consent{};
};

/// Runs the session. `respondent` is null for a virtual participant.
///
/// The device comes first: it is opened, and compared with the protocol and with the study's
/// profile of it, so that no question is asked for a session that is rejected. A new participant is
/// then added: a person is asked to agree to the protocol's statement and then its questions,
/// before anything is stored. `stop` requests the end of the session after the current trial.
///
/// Errors: ProtocolError; ResultsError; std::runtime_error for a label that is not acceptable,
/// missing consent, another language than the participant's earlier sessions, a session that cannot be resumed, one that is too old without a `late_reason`,
/// an external program that is missing or cannot be used, a device that cannot be opened or that the protocol does not accept (rehearsed_device.h).
SessionEnd run_session(const RunInputs& inputs, const ModelRegistry& models, Respondent* respondent,
                       const std::stop_token& stop,
                       const std::function<void(const AttemptDone&)>& done,
                       const SessionLinks& links = {},
                       const DriverRegistry& drivers = built_in_drivers());

}  // namespace asperity
