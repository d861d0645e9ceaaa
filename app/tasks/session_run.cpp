// Begins or reopens the session, stores its conditions and device, and passes it to a conductor.

#include "app/tasks/session_run.h"

#include <algorithm>
#include <memory>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/plugins/stored_plugins.h"
#include "app/records/session_conditions.h"
#include "app/session/respondents/virtual_participant.h"
#include "app/session/rig/contact_reader.h"
#include "app/session/session_compute.h"
#include "app/tasks/checks/device_requirements.h"
#include "app/tasks/unfinished_session.h"
#include "app/words/coded_phrases.h"
#include "protocols/kinds/experiment_kind.h"
#include "protocols/texts/placeholders.h"

namespace asperity {

namespace {

std::string observer_json(const Protocol& protocol) {
  const ObserverDeclaration& observer = protocol.observer;
  const char* expectation = "none";
  if (observer.expectation == ObserverDeclaration::Expectation::true_surface) {
    expectation = "true_surface";
  } else if (observer.expectation == ObserverDeclaration::Expectation::prior) {
    expectation = "prior";
  }
  nlohmann::ordered_json json{{"expectation", expectation}};
  if (observer.gaussian_wavelength_m) {
    json["gaussian_wavelength_m"] = *observer.gaussian_wavelength_m;
  }
  json["deaf"] = observer.deaf;
  json["feature_noise"] = observer.feature_noise;
  json["position_bias"] = observer.position_bias;
  json["lapse"] = observer.lapse;
  if (observer.discrimination.magnitude_decreases) json["effect"] = "decreases";
  const std::vector<const ExperimentKind*> kinds = kinds_of(protocol);
  const bool asks_for_numbers = std::any_of(
      kinds.begin(), kinds.end(),
      [](const ExperimentKind* kind) { return std::holds_alternative<NumberForm>(kind->form); });
  const bool judges_magnitudes =
      std::any_of(kinds.begin(), kinds.end(),
                  [](const ExperimentKind* kind) { return !kind->has_expectations; });
  if (judges_magnitudes) json["magnitude_of"] = text_of(observer.magnitude_of);
  if (asks_for_numbers) json["exponent"] = observer.magnitude.exponent;
  return json.dump();
}

std::string conditions_json(const ProgramIdentity& program, const Rig& rig,
                            const ModelRegistry& models) {
  nlohmann::ordered_json json{{"utc", rig.clock().utc()},
                              {"program_version", program.version},
                              {"program_commit", program.commit},
                              {"program_sha256", program.sha256},
                              {"instruction_set", program.instruction_set},
                              {"os", program.os},
                              {"pacing", rig.pacing()},
                              {"scheduling", rig.scheduling()},
                              {"device", device_text(rig.capability())},
                              {"judged_force", text_of(judged_force_of(rig.capability()))}};
  if (auto compute = json_of_compute(models); !compute.is_null()) json["compute"] = compute;
  return json.dump();
}

/// Stores the profile of the session's device, and the parts of the plan that exceed it.
void store(const RehearsedDevice& device, Study& study, std::int64_t session_id,
           std::int64_t now_ns) {
  if (!device.profile) return;
  study.add_event(session_id, {.time_ns = now_ns,
                               .kind = "device_profile",
                               .text = device.profile->name + ' ' + device.profile->model +
                                       ", measured " + device.profile->measured_utc,
                               .data_json = json_text_of(*device.profile)});
  for (const RehearsalWarning& warning : device.warnings) {
    const nlohmann::ordered_json data{{"check", warning.id},
                                      {"stimulus", warning.stimulus},
                                      {"asked", warning.asked},
                                      {"device", warning.device}};
    study.add_event(session_id, {.time_ns = now_ns,
                                 .kind = "rehearsal",
                                 .text = warning.text.english(),
                                 .data_json = data.dump()});
  }
}

/// Stores the statement that the participant agreed to if it is not the one in the protocol.
void store_consent(const SessionRun& session_run, const Protocol& protocol, Study& study,
                   std::int64_t session_id, std::int64_t now_ns) {
  if (!session_run.consent_utc || placeholders_in(protocol.consent_statement).empty()) return;
  const nlohmann::ordered_json data{{"place", "/consent/statement"}};
  study.add_event(session_id, event_row(now_ns, "text_as_read", session_run.consent, data.dump()));
}

/// Stores the plug-ins that this segment of the session loaded.
void store_plugins(const ModelRegistry& models, Study& study, std::int64_t session_id,
                   std::int64_t now_ns) {
  for (const EventRow& event : plugin_events(models, now_ns)) study.add_event(session_id, event);
}

/// Stores a change of device, before the new device becomes that of the new stretch.
void store_changed_device(const Rig& rig, Study& study, const SessionRow& session) {
  const DeviceCapability& device = rig.capability();
  if (last_recorded_device(study, session).is_same_as(recorded_device(device))) return;
  study.add_event(session.id, {.time_ns = rig.clock().now_ns(),
                               .kind = kDeviceChanged,
                               .text = device_text(device),
                               .data_json = device_json(device, rig.limits())});
}

void store_late_resume(const SessionRun& session_run, Study& study, std::int64_t now_ns) {
  if (!session_run.late) return;
  const nlohmann::ordered_json data{{"age_hours", session_run.late->age_hours},
                                    {"maximum_age_hours", session_run.late->maximum_age_hours}};
  study.add_event(session_run.unfinished->id,
                  event_row(now_ns, kResumedLate, session_run.late_reason, data.dump()));
}

}  // namespace

SessionEnd run_on_rig(Study& study, const Protocol& protocol, StimulusBuilder& builder,
                      const ProgramIdentity& program, const SessionRun& session_run, Rig& rig,
                      Respondent* person, const std::stop_token& stop,
                      const std::function<void(const AttemptDone&)>& done,
                      const SessionLinks& links) {
  const std::vector<Phrase> complaints = complaints_about_device(protocol, rig.capability());
  if (!complaints.empty()) {
    throw PhrasedError(
        phrase("RunSession", "%1; choose another device, or relax the requirement in the protocol")
            .with(complaints.front()));
  }
  OpenSession session{};
  if (session_run.unfinished) {
    session = reopen(study, protocol, *session_run.unfinished);
    // Once every level is stored, none is needed.
    if (!session.course->is_complete()) require_program(protocol, session_run.level_program);
    store_changed_device(rig, study, session.row);
    store_late_resume(session_run, study, rig.clock().now_ns());
  } else {
    require_program(protocol, session_run.level_program);
    SessionConditions conditions{};
    conditions.mode = session_run.mode;
    conditions.seed = session_run.seed;
    conditions.counterbalance_row = session_run.counterbalance_row;
    conditions.group = session_run.group;
    conditions.consent_utc = session_run.consent_utc;
    conditions.mirrored = session_run.mirrored;
    conditions.pacing = rig.pacing();
    conditions.scheduling = rig.scheduling();
    conditions.device = rig.capability();
    conditions.limits = rig.limits();
    conditions.started_utc = rig.clock().utc();
    conditions.clock_zero_ns = rig.clock().now_ns();
    if (person == nullptr) conditions.observer_json = observer_json(protocol);
    session = begin_session(study, protocol, session_run.participant.label, conditions, program);
    store_consent(session_run, protocol, study, session.row.id, rig.clock().now_ns());
  }
  store(session_run.device, study, session.row.id, rig.clock().now_ns());
  store_plugins(builder.models(), study, session.row.id, rig.clock().now_ns());
  std::unique_ptr<VirtualParticipant> stand_in{};
  if (person == nullptr) {
    const Random random = Random(std::stoull(session.row.seed)).split("participant");
    stand_in = std::make_unique<VirtualParticipant>(
        protocol, expectations_of(protocol, builder, random), session_run.participant, random);
    person = stand_in.get();
  }
  Conductor conductor(study, protocol, builder, rig, *person,
                      {.record = session_run.record,
                       .makes_ahead = rig.pacing() == "real_time",
                       .level_program = session_run.level_program,
                       .conditions_json = conditions_json(program, rig, builder.models()),
                       .done = done,
                       .links = links});
  const std::stop_callback on_stop(
      stop, [&conductor] { conductor.requests().stop_after(StopAfter::trial); });
  return conductor.run(std::move(session));
}

}  // namespace asperity
