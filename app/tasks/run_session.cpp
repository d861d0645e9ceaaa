// Checks the participant, makes the rig and the respondent, stores a new participant, and runs the session.

#include "app/tasks/run_session.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <stdexcept>
#include <thread>
#include <utility>

#include "app/device_bench/device_choice.h"
#include "app/device_bench/measure_device.h"
#include "app/profiles/device_kind.h"
#include "app/records/participant_answers.h"
#include "app/records/session_conditions.h"
#include "app/session/respondents/virtual_participant.h"
#include "app/session/session_compute.h"
#include "app/tasks/checks/device_requirements.h"
#include "app/tasks/group_choice.h"
#include "app/tasks/label_notice.h"
#include "app/tasks/protocol_files.h"
#include "app/tasks/session_language.h"
#include "app/tasks/session_run.h"
#include "app/tasks/unfinished_session.h"
#include "app/words/reason.h"
#include "protocols/texts/protocol_texts.h"

namespace asperity {

namespace {

constexpr std::int64_t kHour_ns = 3'600'000'000'000;

/// Waits before a session, where no servo is ticking. A stop request takes effect within a few
/// hundredths of a second; there is then no session yet.
Wait sleep_until_stopped(const std::stop_token& stop, const SessionLinks& links) {
  return [stop, links](double duration_s) {
    constexpr double kSleep_s = 0.02;
    double left_s = duration_s;
    do {
      std::this_thread::sleep_for(std::chrono::duration<double>(std::min(left_s, kSleep_s)));
      left_s -= kSleep_s;
      if (links.requests != nullptr) {
        if (const auto reason = links.requests->take_abort()) {
          throw RespondentGone(*reason);
        }
      }
      if (stop.stop_requested()) throw RespondentGone(phrase_of(Reason::stopped_as_asked));
    } while (left_s > 0.0);
  };
}

/// Asks a participant to agree to the protocol's statement, which is returned as it was read; without agreement nothing is stored.
std::string ask_consent(const Protocol& protocol, Respondent& respondent, SessionMonitor* monitor,
                        const Wait& wait) {
  std::string statement = consent_as_read(protocol);
  const Question question{
      .name = "consent",
      .prompt = statement + "\n\nDo you agree?",
      .options = {{.value = "yes", .text = "yes"}, {.value = "no", .text = "no"}}};
  if (monitor != nullptr) monitor->show(scene_of_form(question));
  const std::optional<Answer> answer = respondent.answer(question, wait);
  if (!answer || items_of(question, *answer).front().answer != "yes") {
    throw PhrasedError(phrase("RunSession",
                              "the participant did not agree to take part, and nothing was stored; "
                              "run the session with another participant"));
  }
  return statement;
}

ParticipantRow ask_person(const Protocol& protocol, const std::string& label,
                          Respondent& respondent, const std::string& created_utc,
                          SessionMonitor* monitor, const Wait& wait) {
  ParticipantAnswers answers{};
  for (const Question& question : questions_about_participant(protocol)) {
    if (monitor != nullptr) monitor->show(scene_of_form(question));
    const std::optional<Answer> answer = respondent.answer(question, wait);
    answers[question.name] = answer ? items_of(question, *answer).front().answer : std::string();
  }
  return person_of(label, protocol, answers, created_utc);
}

ParticipantRow new_person(const RunInputs& inputs, const Protocol& protocol, Respondent* respondent,
                          const Clock& clock, const SessionLinks& links, const Wait& wait) {
  if (inputs.is_virtual) {
    ParticipantRow person = virtual_person(1, Random(inputs.seed), clock.utc());
    person.label = inputs.participant;
    return person;
  }
  if (!inputs.new_person) {
    return ask_person(protocol, inputs.participant, *respondent, clock.utc(), links.monitor, wait);
  }
  ParticipantRow person = *inputs.new_person;
  if (person.label != inputs.participant || person.is_virtual) {
    throw PhrasedError(phrase("RunSession",
                              "the new label \"%1\" differs from the label of the session's "
                              "participant, %2; enter the label of that participant")
                           .with(person.label, inputs.participant));
  }
  if (person.created_utc.empty()) person.created_utc = clock.utc();
  return person;
}

/// Opens a participant's device and compares it with its profile and the plan.
/// Errors: PhrasedError where the protocol does not accept it; RespondentGone where a stop was
/// requested before the comparison was complete.
RehearsedDevice taken_device(const RunInputs& inputs, const Protocol& protocol,
                             const DeviceCapability& capability, const std::string& now_utc,
                             StimulusBuilder& builder, const std::stop_token& stop) {
  const WantedDevice wanted{.which = {capability.name, capability.model, capability.serial},
                            .asked = inputs.device,
                            .options = as_command_options(inputs.driver_options),
                            .has_motors = capability.actuated_degrees_of_freedom > 0};
  RehearsedDevice device = profiled_device(protocol, wanted, inputs.study, now_utc);
  if (device.refusal.empty()) {
    compare(device, protocol, [&](const DeviceProfile& profile) {
      return rehearse_once(inputs.rehearsal.get(), protocol, profile, inputs.study, builder,
                           {.stop = stop, .progress = inputs.comparing});
    });
    // An incomplete comparison would be mistaken for a complete one.
    if (device.profile && stop.stop_requested()) {
      throw RespondentGone(phrase_of(Reason::stopped_as_asked));
    }
    if (inputs.rehearsed) inputs.rehearsed(device);
  }
  if (!device.refusal.empty()) throw PhrasedError(device.refusal);
  return device;
}

/// The first hour of the simulated calendar without a session.
std::int64_t free_hour(const Study& study) {
  std::int64_t hour = 0;
  for (const SessionRow& row : study.sessions()) {
    if (row.pacing == "stepped") hour = std::max(hour, last_time_ns(study, row) / kHour_ns + 1);
  }
  return hour;
}

std::unique_ptr<Rig> make_rig(const RunInputs& inputs, const Protocol& protocol, const Study& study,
                              const std::optional<SessionRow>& unfinished,
                              const DriverRegistry& drivers, const std::stop_token& stop) {
  RigSettings settings = rig_settings_for(protocol, inputs.faults, inputs.device);
  settings.servo = inputs.servo;
  settings.servo.rate_Hz = protocol.rate_Hz;
  const std::int64_t not_before_ns = unfinished ? last_time_ns(study, *unfinished) : 0;
  if (inputs.pacing == RunPacing::real_time) {
    const std::uint64_t seed = unfinished ? std::stoull(unfinished->seed) : inputs.seed;
    NamedDevice device{.name = inputs.device, .options = inputs.driver_options};
    device.options.stop = stop;
    return open_rig(device, drivers, settings, Random(seed).split("hand"), not_before_ns);
  }
  auto rig = std::make_unique<SteppedRig>(
      settings, unfinished ? unfinished->clock_zero_ns / kHour_ns : free_hour(study));
  rig->move_clock_to(std::max(rig->clock().now_ns(), not_before_ns));
  return rig;
}

SessionRow unfinished_session(const Study& study, const RunInputs& inputs,
                              const Protocol& protocol) {
  const SessionRow row =
      find_unfinished(study, protocol, inputs.participant, inputs.resumed_session);
  const bool was_stepped = row.pacing == "stepped";
  if (was_stepped != (inputs.pacing == RunPacing::stepped)) {
    throw PhrasedError((was_stepped ? phrase("RunSession",
                                             "session %1 of participant %2 runs on a simulated "
                                             "clock; resume it without --realtime")
                                    : phrase("RunSession",
                                             "session %1 of participant %2 was begun in real time; "
                                             "resume it with --realtime"))
                           .with(std::to_string(row.session), inputs.participant));
  }
  return row;
}

/// A session that is older than the protocol's maximum requires a reason to be resumed.
void require_late_reason(const SessionRun& session_run) {
  if (!session_run.late || !session_run.late_reason.empty()) return;
  throw PhrasedError(phrase("RunSession",
                            "%1; to resume it nevertheless, give the reason with --late-reason; "
                            "the reason is stored and stated in the report")
                         .with(complaint_about(*session_run.late)));
}

/// A participant begins a session only when the last one is finished and the protocol plans another.
/// A pilot session can be repeated at will.
void check_may_begin(const Study& study, const RunInputs& inputs, const Protocol& protocol) {
  const std::optional<ParticipantRow> known = study.participant(inputs.participant);
  if (known && known->withdrawn) {
    throw PhrasedError(
        phrase("RunSession", "participant %1 has withdrawn from the study; use another label")
            .with(inputs.participant));
  }
  const auto [completed, unfinished] =
      sessions_of_participant(study, protocol, inputs.participant, inputs.mode);
  if (unfinished) {
    throw PhrasedError(phrase("RunSession",
                              "participant %1 has an unfinished session %2 of this protocol; "
                              "resume it with --resume")
                           .with(inputs.participant, std::to_string(unfinished->session)));
  }
  if (const auto complaint =
          complaint_about_language(study, protocol, inputs.participant, inputs.mode)) {
    throw PhrasedError(*complaint);
  }
  if (inputs.mode == SessionMode::run && completed >= protocol.sessions) {
    throw PhrasedError(phrase("RunSession",
                              "participant %1 has completed all sessions of this protocol (planned "
                              "per participant: %2); choose another participant")
                           .with(inputs.participant, std::to_string(protocol.sessions)));
  }
}

/// The group that the experimenter assigns; nothing where there are no groups, and where the store
/// assigns it. Errors: PhrasedError for a group that is missing, unknown or not to be stated.
std::optional<std::string> group_of_new_session(const Study& study, const Protocol& protocol,
                                                const RunInputs& inputs, SessionMode mode) {
  const std::optional<Phrase> complaint = complaint_about_group(
      protocol, study.group_of_participant(inputs.participant, protocol.name, mode), inputs.group);
  if (complaint) throw PhrasedError(*complaint);
  return inputs.group;
}

}  // namespace

SessionEnd run_session(const RunInputs& inputs, const ModelRegistry& models, Respondent* respondent,
                       const std::stop_token& stop,
                       const std::function<void(const AttemptDone&)>& done,
                       const SessionLinks& links, const DriverRegistry& drivers) {
  if (const auto complaint = complaint_about_label(inputs.participant, inputs.is_virtual)) {
    throw PhrasedError(*complaint);
  }
  if (inputs.is_virtual) require_virtual_hand_on(inputs.device);
  StimulusBuilder builder(models, inputs.study);
  const Protocol protocol =
      load_protocol_to_run(inputs.protocol, inputs.study, builder, inputs.rehearsal.get());
  if (inputs.on_gpu.value_or(protocol.computes_on_gpu)) {
    require_two_bodies(protocol, models);
    builder.compute_on(inputs.pacing == RunPacing::real_time ? compute_in_real_time()
                                                             : compute_on_simulated_clock());
  }
  // A session that is resumed needs none once every level is stored (`run_on_rig`).
  if (!inputs.resume || inputs.level_program) require_program(protocol, inputs.level_program);
  Study study = Study::open(inputs.study, Access::read_write);
  study.mark_crashed_sessions();
  const StudyLock lock(inputs.study, Study::session_lock_name(inputs.participant));
  if (inputs.pacing == RunPacing::real_time) require_nothing_measured(inputs.study);
  const std::optional<ParticipantRow> known = study.participant(inputs.participant);
  if (known && known->is_virtual != inputs.is_virtual) {
    throw PhrasedError(
        (known->is_virtual
             ? phrase("RunSession", "participant %1 is a virtual participant; use --virtual")
             : phrase("RunSession",
                      "participant %1 is human; leave out --virtual, or use another label"))
            .with(inputs.participant));
  }
  SessionRun session_run{};
  session_run.mode = inputs.is_virtual ? SessionMode::simulate : inputs.mode;
  session_run.seed = inputs.seed;
  session_run.level_program = inputs.level_program;
  if (!inputs.resume && !inputs.is_virtual) check_may_begin(study, inputs, protocol);
  if (!inputs.resume)
    session_run.group = group_of_new_session(study, protocol, inputs, session_run.mode);
  if (inputs.resume) {
    session_run.unfinished = unfinished_session(study, inputs, protocol);
    session_run.late = late_resume(study, protocol, *session_run.unfinished);
    session_run.late_reason = inputs.late_reason;
    require_late_reason(session_run);
  }
  const std::unique_ptr<Rig> rig =
      make_rig(inputs, protocol, study, session_run.unfinished, drivers, stop);
  builder.assume_position_step(rig->capability().position_resolution_m);
  const std::vector<Phrase> complaints = complaints_about_device(protocol, rig->capability());
  if (!complaints.empty()) {
    throw PhrasedError(
        phrase("RunSession", "%1; choose another device, or relax the requirement in the protocol")
            .with(complaints.front()));
  }
  if (session_run.mode == SessionMode::run) {
    if (const auto blocker = study_data_blocker(protocol, recorded_device(rig->capability()))) {
      throw PhrasedError(phrase("StudyData", "%1; %2 (Pilot: --mode pilot)")
                             .with(blocker->problem, blocker->remedy));
    }
  }
  if (!inputs.is_virtual) {
    session_run.device =
        taken_device(inputs, protocol, rig->capability(), rig->clock().utc(), builder, stop);
  }
  if (session_run.unfinished && inputs.resumed) {
    const RecordedDevice before = last_recorded_device(study, *session_run.unfinished);
    const RecordedDevice now = recorded_device(rig->capability());
    if (!before.is_same_as(now)) {
      inputs.resumed(phrase("RunSession",
                            "the session last ran on %1 and is resumed on %2; this is stored with "
                            "the session and stated in its report")
                         .with(before.full_text(), now.full_text()));
    }
  }
  const Wait wait = sleep_until_stopped(stop, links);
  if (!inputs.resume && inputs.noticed) {
    if (const auto notice = label_notice(study, protocol, inputs.participant, session_run.mode)) {
      inputs.noticed(*notice, wait);
    }
  }
  if (inputs.ready) inputs.ready(protocol);
  if (!inputs.is_virtual && !inputs.resume && !protocol.consent_statement.empty()) {
    session_run.consent =
        inputs.consent ? *inputs.consent : ask_consent(protocol, *respondent, links.monitor, wait);
    session_run.consent_utc = rig->clock().utc();
  }
  session_run.mirrored = inputs.mirrored;
  if (known) {
    session_run.participant = *known;
  } else {
    session_run.participant = new_person(inputs, protocol, respondent, rig->clock(), links, wait);
    study.add_participant(session_run.participant);
  }
  return run_on_rig(study, protocol, builder, this_program(), session_run, *rig,
                    inputs.is_virtual ? nullptr : respondent, stop, done, links);
}

}  // namespace asperity
