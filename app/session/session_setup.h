// Opens a session in the store, or finds the one to go on with.

#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/study_files/program.h"
#include "device/device_capability.h"
#include "protocols/design/protocol.h"
#include "protocols/plan/plan.h"
#include "results_schema/study.h"

namespace asperity {

/// How a new session is to be run; stored with it.
struct SessionConditions {
  SessionMode mode = SessionMode::run;
  std::uint64_t seed = 0;
  std::optional<int> counterbalance_row{};  ///< otherwise the least used one
  std::string pacing{};
  std::string scheduling{};
  DeviceCapability device{};
  std::string started_utc{};
  std::int64_t clock_zero_ns = 0;
  std::optional<std::string> consent_utc{};  ///< when the person agreed to the protocol's statement
  std::string observer_json = "null";
  bool mirrored = false;
};

/// A session that is about to run: its row, its plan, and what has been done of it.
struct OpenSession {
  SessionRow row{};
  Plan plan{};
  std::vector<AttemptRow> attempts{};
  bool resumed = false;
};

/// As SessionRow::device and `device_json` have it.
std::string device_text(const DeviceCapability& device);
std::string capability_json(const DeviceCapability& device);

/// The participant is to see or to hear how force and speed meet their bands.
bool guides_participants(const Protocol& protocol);

/// The files that a protocol names, with their hashes.
///
/// Errors: std::runtime_error with one sentence per file that is missing.
std::vector<StimulusFileRow> hash_files(const Protocol& protocol,
                                        const std::filesystem::path& study_folder);

/// Stores a new session of `participant` with its whole plan. Errors: ResultsError.
OpenSession begin_session(Study& study, const Protocol& protocol, const std::string& participant,
                          const SessionConditions& conditions, const ProgramIdentity& program);

/// What happened in a session in the order of time: what hangs on its attempts among the rest.
std::vector<EventRow> events_in_order(std::vector<EventRow> events,
                                      const std::vector<AttemptRow>& attempts);

/// The session has ended as the protocol specifies although not every trial of it was asked: the
/// criterion of a practice was not met, and the protocol ends the session then. It is not resumed.
bool has_ended_by_rule(const Study& study, const Protocol& protocol, const SessionRow& row);
/// Completed, or ended by a rule of the protocol: nothing is left to resume.
bool has_ended(const Study& study, const Protocol& protocol, const SessionRow& row);

/// A session of this participant and protocol that is neither completed nor ended by rule: the one
/// with this id, or without an id the latest. Nothing when there is none.
std::optional<SessionRow> unfinished_row(const Study& study, const Protocol& protocol,
                                         const std::string& participant,
                                         std::optional<std::int64_t> id);

/// The same where there has to be one. Errors: std::runtime_error where there is none.
SessionRow find_unfinished(const Study& study, const Protocol& protocol,
                           const std::string& participant, std::optional<std::int64_t> id);

/// A session of the store, ready to go on.
///
/// The plan is made again from the stored seed and row and has to be the stored one; the files have
/// to be those it began with.
///
/// Errors: std::runtime_error saying what has changed.
OpenSession reopen(const Study& study, const Protocol& protocol, const SessionRow& row);

}  // namespace asperity
