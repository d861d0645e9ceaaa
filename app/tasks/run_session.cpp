// One session of one participant.

#include "app/tasks/run_session.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <stdexcept>
#include <thread>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/conductor/virtual_participant.h"
#include "app/tasks/protocol_files.h"
#include "app/tasks/sitting.h"
#include "results_schema/table.h"

namespace asperity {

namespace {

constexpr std::int64_t kHour_ns = 3'600'000'000'000;

/// Before the session there is no servo to go on ticking.
void sleep(double duration_s) {
  std::this_thread::sleep_for(std::chrono::duration<double>(duration_s));
}

/// Asks a person to agree to the protocol's statement; nothing is stored of one who does not.
void ask_consent(const Protocol& protocol, Respondent& respondent) {
  const Question question{.name = "consent",
                          .prompt = protocol.consent_statement + "\n\nDo you agree?",
                          .form = Question::Form::choice,
                          .options = {"yes", "no"}};
  if (respondent.answer(question, sleep) != "yes") {
    throw std::runtime_error("the participant did not agree to take part; nothing was stored");
  }
}

ParticipantRow ask_person(const Protocol& protocol, const std::string& label,
                          Respondent& respondent, const std::string& created_utc) {
  ParticipantRow person{};
  person.label = label;
  person.created_utc = created_utc;
  nlohmann::ordered_json others = nlohmann::ordered_json::object();
  for (const Question& question : protocol.participant_questions) {
    const std::string answer = respondent.answer(question, sleep);
    if (answer.empty()) continue;
    if (question.name == "sex") {
      person.sex = answer == "female" ? "F" : answer == "male" ? "M" : "X";
    } else if (question.name == "handedness") {
      person.handedness = answer == "left" || answer == "right" ? answer : "ambidextrous";
    } else if (question.name == "age") {
      person.age_years = number_in(answer);
    } else {
      others[question.name] = answer;
    }
  }
  person.answers_json = others.dump();
  return person;
}

/// The first hour of the simulated calendar that no session lies in.
std::int64_t free_hour(const Study& study) {
  std::int64_t hour = 0;
  for (const SessionRow& row : study.sessions()) {
    if (row.pacing == "stepped") hour = std::max(hour, last_time_ns(study, row) / kHour_ns + 1);
  }
  return hour;
}

std::unique_ptr<Rig> make_rig(const RunInputs& inputs, const Protocol& protocol, const Study& study,
                              const std::optional<SessionRow>& unfinished) {
  const RigSettings settings = rig_settings_for(protocol, inputs.faults);
  const std::int64_t not_before_ns = unfinished ? last_time_ns(study, *unfinished) : 0;
  if (inputs.pacing == RunPacing::real_time) {
    const std::uint64_t seed = unfinished ? std::stoull(unfinished->seed) : inputs.seed;
    return std::make_unique<RealTimeRig>(settings, HandHabits{}, Random(seed).split("hand"),
                                         Scheduling::fifo_if_permitted, not_before_ns);
  }
  auto rig = std::make_unique<SteppedRig>(
      settings, unfinished ? unfinished->clock_zero_ns / kHour_ns : free_hour(study));
  rig->move_clock_to(std::max(rig->clock().now_ns(), not_before_ns));
  return rig;
}

SessionRow unfinished_session(const Study& study, const RunInputs& inputs,
                              const Protocol& protocol) {
  const SessionRow row = find_unfinished(study, protocol, inputs.participant);
  const bool was_stepped = row.pacing == "stepped";
  if (was_stepped != (inputs.pacing == RunPacing::stepped)) {
    throw std::runtime_error("session " + std::to_string(row.session) + " of participant " +
                             inputs.participant +
                             (was_stepped ? " runs on a simulated clock; go on without --realtime"
                                          : " was begun in real time; go on with --realtime"));
  }
  return row;
}

/// A person begins a session only when the last one is finished and the protocol plans another.
void check_may_begin(const Study& study, const RunInputs& inputs, const Protocol& protocol) {
  int completed = 0;
  for (const SessionRow& row : study.sessions()) {
    if (row.participant != inputs.participant || row.mode != inputs.mode ||
        study.protocol(row.protocol_id).source != protocol.source) {
      continue;
    }
    if (row.state != SessionState::completed) {
      throw std::runtime_error("participant " + inputs.participant + " has an unfinished session " +
                               std::to_string(row.session) +
                               " of this protocol; go on with it by --resume");
    }
    ++completed;
  }
  if (inputs.mode == SessionMode::run && completed >= protocol.sessions) {
    throw std::runtime_error("participant " + inputs.participant +
                             " has done all sessions of this "
                             "protocol, which plans " +
                             std::to_string(protocol.sessions) + " per participant");
  }
}

}  // namespace

SessionEnd run_session(const RunInputs& inputs, const ModelRegistry& models, Respondent* respondent,
                       const std::stop_token& stop,
                       const std::function<void(const AttemptDone&)>& done, const SessionLinks&) {
  if (const auto complaint = complaint_about_label(inputs.participant, inputs.is_virtual)) {
    throw std::runtime_error(*complaint);
  }
  StimulusBuilder builder(models, inputs.study);
  const Protocol protocol = load_protocol_to_run(inputs.protocol, inputs.study, builder);
  Study study = Study::open(inputs.study, Access::read_write);
  study.mark_crashed_sessions();
  const StudyLock lock(inputs.study, Study::session_lock_name(inputs.participant));
  const std::optional<ParticipantRow> known = study.participant(inputs.participant);
  if (known && known->is_virtual != inputs.is_virtual) {
    throw std::runtime_error("participant " + inputs.participant + " is a " +
                             (known->is_virtual ? "virtual participant; use --virtual"
                                                : "person; --virtual is for virtual participants"));
  }
  Sitting sitting{};
  sitting.mode = inputs.is_virtual ? SessionMode::simulate : inputs.mode;
  sitting.seed = inputs.seed;
  if (!inputs.resume && !inputs.is_virtual) check_may_begin(study, inputs, protocol);
  if (inputs.resume) sitting.unfinished = unfinished_session(study, inputs, protocol);
  const std::unique_ptr<Rig> rig = make_rig(inputs, protocol, study, sitting.unfinished);

  if (!inputs.is_virtual && !inputs.resume && !protocol.consent_statement.empty()) {
    ask_consent(protocol, *respondent);
    sitting.consent_utc = rig->clock().utc();
  }
  if (known) {
    sitting.participant = *known;
  } else {
    if (inputs.is_virtual) {
      sitting.participant = virtual_person(1, Random(inputs.seed), rig->clock().utc());
      sitting.participant.label = inputs.participant;
    } else {
      sitting.participant =
          ask_person(protocol, inputs.participant, *respondent, rig->clock().utc());
    }
    study.add_participant(sitting.participant);
  }
  return sit(study, protocol, builder, this_program(), sitting, *rig,
             inputs.is_virtual ? nullptr : respondent, stop, done);
}

}  // namespace asperity
