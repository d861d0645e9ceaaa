// Creates a session in the store, or finds the one to resume.

#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/study_files/program.h"
#include "device/device_capability.h"
#include "device/force_limiter.h"
#include "protocols/design/protocol.h"
#include "protocols/plan/course.h"
#include "protocols/plan/plan.h"
#include "results_schema/study.h"

namespace asperity {

/// The conditions of a new session, stored with it.
struct SessionConditions {
  SessionMode mode = SessionMode::run;
  std::uint64_t seed = 0;
  /// If absent, the least used one; in a study that is divided among stations, that of the participant's place.
  std::optional<int> counterbalance_row{};
  /// Of a protocol with groups; if absent, that of the participant's earlier sessions, or the one
  /// with the fewest participants, or that of the participant's place.
  std::optional<std::string> group{};
  std::string pacing{};
  std::string scheduling{};
  DeviceCapability device{};
  ForceLimits limits{};  ///< of the device
  std::string started_utc{};
  std::int64_t clock_zero_ns = 0;
  /// When the participant agreed to the protocol's statement.
  std::optional<std::string> consent_utc{};
  std::string observer_json = "null";
  bool mirrored = false;
};

/// A session that is about to run: its row, its trial sequence, and its attempts so far.
struct OpenSession {
  SessionRow row{};
  std::optional<Course> course{};  ///< always set; refers to the protocol
  std::vector<AttemptRow> attempts{};
  bool resumed = false;
};

/// The device as SessionRow::device and SessionRow::device_json contain it.
std::string device_text(const DeviceCapability& device);
std::string device_json(const DeviceCapability& device, const ForceLimits& limits);

/// What determines the plan of a session.
Allocation allocation_of(const SessionRow& row);

/// The row of one planned trial.
PlannedTrialRow planned_row(const Trial& trial);

/// The random stream of an attempt: of its renderers and of a virtual hand.
Random random_of_attempt(const SessionRow& session, int trial, int attempt);

/// Whether the participant sees or hears how force and speed meet their bands.
bool guides_participants(const Protocol& protocol);

/// The files that a protocol names, with their hashes.
///
/// Errors: std::runtime_error with one sentence per file that is missing.
std::vector<StimulusFileRow> hash_files(const Protocol& protocol,
                                        const std::filesystem::path& study_folder);

/// Copies the files that a protocol names from one study to another, which has none of them.
///
/// Errors: as `hash_files`; std::filesystem::filesystem_error.
void copy_files(const Protocol& protocol, const std::filesystem::path& from,
                const std::filesystem::path& to);

/// Stores a new session of `participant` with its plan, as far as it is determined. The protocol must
/// outlive the session. Errors: ResultsError.
OpenSession begin_session(Study& study, const Protocol& protocol, const std::string& participant,
                          const SessionConditions& conditions, const ProgramIdentity& program);

/// The events of a session in the order of time, including those of its attempts.
std::vector<EventRow> events_in_order(std::vector<EventRow> events,
                                      const std::vector<AttemptRow>& attempts);

/// Whether the session ended as the protocol specifies although not every trial of it was asked:
/// the criterion of a practice was not met, and the protocol ends the session in that case. It is
/// not resumed.
bool has_ended_by_rule(const Study& study, const Protocol& protocol, const SessionRow& row);
/// Completed, or ended by a rule of the protocol: nothing is left to resume.
bool has_ended(const Study& study, const Protocol& protocol, const SessionRow& row);

/// A session of this participant and protocol that is neither completed nor ended by rule: the one
/// with this id, or without an id the latest. Nothing when there is none.
std::optional<SessionRow> unfinished_row(const Study& study, const Protocol& protocol,
                                         const std::string& participant,
                                         std::optional<std::int64_t> id);

/// The same session, where one is required. Errors: std::runtime_error where there is none.
SessionRow find_unfinished(const Study& study, const Protocol& protocol,
                           const std::string& participant, std::optional<std::int64_t> id);

/// A session of the store, ready to be resumed.
///
/// The plan is made again from the stored seed, row, group and responses, and has to equal the stored
/// one; the files have to be unchanged since the session began. Trials that the last response
/// determined may be missing from the store: the session was interrupted before.
///
/// Errors: std::runtime_error that states what has changed.
OpenSession reopen(const Study& study, const Protocol& protocol, const SessionRow& row);

}  // namespace asperity
