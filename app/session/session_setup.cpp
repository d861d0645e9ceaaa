// Stores a session with its plan, and recomputes the plan to compare it when the session is resumed.

#include "app/session/session_setup.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <nlohmann/json.hpp>

#include "analysis/numbers/random.h"
#include "analysis/words/phrase.h"
#include "app/session/trial_outcome.h"
#include "app/study_files/dealt_places.h"
#include "app/words/phrase_of_error.h"
#include "protocols/file/protocol_reader.h"
#include "protocols/plan/groups.h"
#include "results_schema/hashes/sha256.h"

namespace asperity {

namespace {

ProtocolRow protocol_row(const Protocol& protocol) {
  ProtocolRow row{};
  row.name = protocol.name;
  row.version = protocol.version;
  row.kind = text_of(protocol.kind);
  row.design = text_of(protocol.design);
  row.source_sha256 = sha256_of(protocol.source);
  row.source = protocol.source;
  return row;
}

std::vector<PlannedTrialRow> planned_rows(const Plan& plan) {
  std::vector<PlannedTrialRow> rows{};
  rows.reserve(plan.trials.size());
  for (const Trial& trial : plan.trials) rows.push_back(planned_row(trial));
  return rows;
}

/// The number of trials where it depends on responses.
std::optional<int> expected_trials_of(const Protocol& protocol) {
  const auto has_procedure = [](const auto& each) { return each.second.procedure.has_value(); };
  if (std::none_of(protocol.blocks.begin(), protocol.blocks.end(), has_procedure)) return {};
  return expected_trials(protocol);
}

/// The places of the whole study that are dealt to this one, if it is divided among stations.
void add_dealt_places(SessionClaim& claim, const Study& study, const Protocol& protocol) {
  const std::vector<PlaceRange> ranges = dealt_places(study.folder());
  int last = 0;
  for (const PlaceRange& range : ranges) last = std::max(last, range.last);
  const std::vector<Allocation> allocations =
      allocations_in_turn(protocol, text_of(SessionMode::run), last);
  for (const PlaceRange& range : ranges) {
    for (int place = range.first; place <= range.last; ++place) {
      const Allocation& allocation = allocations[static_cast<std::size_t>(place - 1)];
      claim.places.push_back(
          {.place = place, .group = allocation.group, .row = allocation.counterbalance_row});
    }
  }
}

/// Whether the stored trials are those of the plan, without or with those that the last response determined.
bool is_stored_plan(const std::vector<PlannedTrialRow>& stored, const Course& course) {
  const std::deque<Trial>& trials = course.plan().trials;
  if (stored.size() != trials.size() && stored.size() != course.trials_before_last_outcome()) {
    return false;
  }
  return std::equal(stored.begin(), stored.end(), trials.begin(),
                    [](const PlannedTrialRow& row, const Trial& trial) {
                      return row.plan_json == json_of(trial) && row.block == trial.block;
                    });
}

}  // namespace

Allocation allocation_of(const SessionRow& row) {
  return {.seed = std::stoull(row.seed),
          .counterbalance_row = row.counterbalance_row,
          .group = row.group_level.value_or("")};
}

Random random_of_attempt(const SessionRow& session, int trial, int attempt) {
  return Random(std::stoull(session.seed))
      .split("attempt")
      .split(static_cast<std::uint64_t>(trial))
      .split(static_cast<std::uint64_t>(attempt));
}

PlannedTrialRow planned_row(const Trial& trial) {
  PlannedTrialRow row{};
  row.trial = trial.ordinal;
  row.block = trial.block;
  row.block_ordinal = trial.block_ordinal;
  row.phase = text_of(trial.phase);
  row.repetition = trial.repetition;
  if (trial.track) {
    row.track = trial.track->track;
    row.step = trial.track->step;
  }
  row.is_catch = trial.catch_trial.has_value();
  row.factors_json = factors_json_of(trial);
  row.plan_json = json_of(trial);
  return row;
}

std::string device_text(const DeviceCapability& device) {
  return device.model.empty() ? device.name : device.name + ' ' + device.model;
}

std::string device_json(const DeviceCapability& device, const ForceLimits& limits) {
  const auto corner = [](const glm::dvec3& p) {
    return nlohmann::ordered_json::array({p.x, p.y, p.z});
  };
  nlohmann::ordered_json json{{"name", device.name},
                              {"model", device.model},
                              {"serial", device.serial},
                              {"sensed_degrees_of_freedom", device.sensed_degrees_of_freedom},
                              {"actuated_degrees_of_freedom", device.actuated_degrees_of_freedom},
                              {"workspace_minimum_m", corner(device.workspace_minimum_m)},
                              {"workspace_maximum_m", corner(device.workspace_maximum_m)},
                              {"peak_force_N", device.peak_force_N},
                              {"continuous_force_N", device.continuous_force_N},
                              {"position_resolution_m", device.position_resolution_m},
                              {"maximum_rate_Hz", device.maximum_rate_Hz},
                              {"maximum_speed_m_per_s", nullptr},
                              {"buttons", device.buttons},
                              {"slew_limit_N_per_ms", limits.slew_N},
                              {"slew_limit_N_m_per_ms", limits.slew_N_m}};
  if (std::isfinite(device.maximum_speed_m_per_s)) {
    json["maximum_speed_m_per_s"] = device.maximum_speed_m_per_s;
  }
  if (!device.remarks.empty()) json["remarks"] = device.remarks;
  return json.dump();
}

bool guides_participants(const Protocol& protocol) {
  return std::any_of(
      protocol.explorations.begin(), protocol.explorations.end(),
      [](const auto& each) { return each.second.guidance != Exploration::Guidance::experimenter; });
}

std::vector<StimulusFileRow> hash_files(const Protocol& protocol,
                                        const std::filesystem::path& study_folder) {
  std::set<std::string> paths{};
  for (const NamedFile& file : files_of(protocol)) {
    for (const std::string& path : paths_of(file)) paths.insert(path);
  }
  std::vector<StimulusFileRow> rows{};
  Phrase missing{};
  for (const std::string& path : paths) {
    const std::filesystem::path full = study_folder / path;
    std::error_code unknown{};
    // What is there and is no file is refused where it is read.
    if (std::filesystem::status(full, unknown).type() == std::filesystem::file_type::not_found) {
      const Phrase one = phrase("SessionSetup",
                                "the protocol \"%1\" names the file %2, which is not in the study "
                                "%3; copy the file into the study")
                             .with(protocol.name, path, study_folder.string());
      missing = missing.empty() ? one : Phrase("%1; %2").with(missing, one);
      continue;
    }
    std::string sha256 = sha256_of_file(full);
    const auto bytes = static_cast<std::int64_t>(std::filesystem::file_size(full));
    rows.push_back({path, std::move(sha256), bytes});
  }
  if (!missing.empty()) throw PhrasedError(missing);
  return rows;
}

void copy_files(const Protocol& protocol, const std::filesystem::path& from,
                const std::filesystem::path& to) {
  for (const StimulusFileRow& file : hash_files(protocol, from)) {
    std::filesystem::create_directories((to / file.path).parent_path());
    std::filesystem::copy_file(from / file.path, to / file.path);
  }
}

OpenSession begin_session(Study& study, const Protocol& protocol, const std::string& participant,
                          const SessionConditions& conditions, const ProgramIdentity& program) {
  OpenSession session{};
  SessionRow& row = session.row;
  row.participant = participant;
  row.protocol_id = study.add_protocol(protocol_row(protocol));
  row.mode = conditions.mode;
  row.seed = std::to_string(conditions.seed);
  row.generator = Random::kName;
  row.program_version = program.version;
  row.program_commit = program.commit;
  row.program_build = program.build;
  row.program_sha256 = program.sha256;
  row.instruction_set = program.instruction_set;
  row.os = program.os;
  row.device = device_text(conditions.device);
  row.device_json = device_json(conditions.device, conditions.limits);
  row.pacing = conditions.pacing;
  row.scheduling = conditions.scheduling;
  row.rate_Hz = protocol.rate_Hz;
  row.started_utc = conditions.started_utc;
  row.clock_zero_ns = conditions.clock_zero_ns;
  if (conditions.consent_utc) {
    row.consent_version = protocol.consent_version;
    row.consent_utc = conditions.consent_utc;
  }
  row.observer_json = conditions.observer_json;
  row.mirrored = conditions.mirrored;
  row.files = hash_files(protocol, study.folder());
  row.group_level = conditions.group;
  row.expected_trials = expected_trials_of(protocol);
  if (conditions.counterbalance_row) {
    row.counterbalance_row = *conditions.counterbalance_row;
    session.course.emplace(protocol, allocation_of(row));
    row.id = study.add_session(row, planned_rows(session.course->plan()));
  } else {
    SessionClaim claim{.rows = counterbalance_rows(protocol), .groups = groups_of(protocol)};
    claim.keeps_places = protocol.groups &&
                         protocol.groups->assigned == Protocol::Groups::Assignment::permuted_blocks;
    if (claim.keeps_places) {
      claim.group_after = [&protocol, mode = text_of(row.mode)](std::size_t assigned) {
        return permuted_group(protocol, mode, assigned);
      };
    }
    if (row.mode == SessionMode::run) add_dealt_places(claim, study, protocol);
    row.id = study.add_session(row, claim, [&](const SessionRow& claimed) {
      session.course.emplace(protocol, allocation_of(claimed));
      return planned_rows(session.course->plan());
    });
  }
  row = study.session(row.id);
  return session;
}

OpenSession reopen(const Study& study, const Protocol& protocol, const SessionRow& row) {
  OpenSession session{};
  session.row = row;
  session.resumed = true;
  session.attempts = study.attempts(row.id);
  session.course.emplace(protocol, allocation_of(row));
  advance_through(*session.course, protocol, session.attempts,
                  set_aside_in(study.decisions(row.id)), SuppliedSteps(study.events(row.id)));
  const std::vector<PlannedTrialRow> stored = study.plan(row.id);
  const std::string number = std::to_string(row.session);
  if (!is_stored_plan(stored, *session.course)) {
    throw PhrasedError(phrase("SessionSetup",
                              "session %1 of participant %2 cannot be resumed: the plan that this "
                              "program makes from its protocol differs from the stored one. Resume "
                              "it with the version with which it began: asperity %3, commit %4")
                           .with(number, row.participant, row.program_version, row.program_commit));
  }
  const std::vector<StimulusFileRow> files = hash_files(protocol, study.folder());
  for (const StimulusFileRow& before : row.files) {
    const auto now = std::find_if(files.begin(), files.end(),
                                  [&before](const auto& file) { return file.path == before.path; });
    if (now == files.end() || now->sha256 != before.sha256) {
      throw PhrasedError(phrase("SessionSetup",
                                "session %1 of participant %2 cannot be resumed: the file %3 has "
                                "changed since the session began; restore the earlier file")
                             .with(number, row.participant, before.path));
    }
  }
  return session;
}

std::vector<EventRow> events_in_order(std::vector<EventRow> events,
                                      const std::vector<AttemptRow>& attempts) {
  for (const AttemptRow& attempt : attempts) {
    events.insert(events.end(), attempt.events.begin(), attempt.events.end());
  }
  std::stable_sort(events.begin(), events.end(),
                   [](const EventRow& a, const EventRow& b) { return a.time_ns < b.time_ns; });
  return events;
}

bool has_ended_by_rule(const Study& study, const Protocol& protocol, const SessionRow& row) {
  if (row.state != SessionState::stopped) return false;
  const std::vector<EventRow> events = study.events(row.id);
  return std::any_of(events.begin(), events.end(), [&protocol](const EventRow& event) {
    if (event.kind != "criterion_not_met") return false;
    const auto block = protocol.blocks.find(event.text);
    return block != protocol.blocks.end() && block->second.until &&
           block->second.until->on_failure == Protocol::Criterion::OnFailure::end_session;
  });
}

bool has_ended(const Study& study, const Protocol& protocol, const SessionRow& row) {
  return row.state == SessionState::completed || has_ended_by_rule(study, protocol, row);
}

std::optional<SessionRow> unfinished_row(const Study& study, const Protocol& protocol,
                                         const std::string& participant,
                                         std::optional<std::int64_t> id) {
  std::optional<SessionRow> found{};
  for (const SessionRow& row : study.sessions()) {
    if (row.participant != participant || row.state == SessionState::completed) continue;
    if (row.withdrawn) continue;
    if (id && row.id != *id) continue;
    if (study.protocol(row.protocol_id).source != protocol.source) continue;
    if (!has_ended_by_rule(study, protocol, row)) found = row;
  }
  return found;
}

SessionRow find_unfinished(const Study& study, const Protocol& protocol,
                           const std::string& participant, std::optional<std::int64_t> id) {
  const std::optional<SessionRow> found = unfinished_row(study, protocol, participant, id);
  if (!found) {
    throw PhrasedError(phrase("SessionSetup",
                              "participant %1 has no unfinished session of the protocol \"%2\" in "
                              "its present form; leave out --resume to begin one")
                           .with(participant, protocol.name));
  }
  return *found;
}

}  // namespace asperity
