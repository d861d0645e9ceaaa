#include "app/tasks/sessions.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <memory>
#include <mutex>
#include <set>
#include <thread>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/conductor/virtual_participant.h"
#include "app/program.h"
#include "app/tasks/protocol_files.h"
#include "results_schema/table.h"

namespace asperity {

namespace {

RigSettings rig_settings(const Protocol& protocol, const std::vector<ScriptedFault>& faults) {
  RigSettings settings{};
  settings.servo.rate_Hz = protocol.rate_Hz;
  settings.limits.force_N = protocol.force_limit_N;
  settings.device.faults = faults;
  return settings;
}

std::string observer_json(const Protocol& protocol) {
  const ObserverDeclaration& observer = protocol.observer;
  const char* expectation = "none";
  if (observer.expectation == ObserverDeclaration::Expectation::true_surface) {
    expectation = "true_surface";
  } else if (observer.expectation == ObserverDeclaration::Expectation::prior) {
    expectation = "prior";
  }
  return nlohmann::ordered_json{{"expectation", expectation},
                                {"deaf", observer.deaf},
                                {"feature_noise", observer.feature_noise},
                                {"position_bias", observer.position_bias},
                                {"lapse", observer.lapse}}
      .dump();
}

/// A session that begins or goes on, and the hour of the simulated calendar in which it lies.
struct Sitting {
  std::string participant{};
  std::optional<SessionRow> unfinished{};
  std::uint64_t seed = 0;
  std::optional<int> counterbalance_row{};
  std::int64_t index = 0;
  bool record = true;
};

std::int64_t last_time_ns(const OpenSession& session, const Study& study) {
  std::int64_t last_ns = session.row.clock_zero_ns;
  for (const AttemptRow& attempt : session.attempts) {
    last_ns = std::max(last_ns, attempt.offset_ns);
  }
  for (const EventRow& event : study.events(session.row.id)) {
    last_ns = std::max(last_ns, event.time_ns);
  }
  return last_ns;
}

/// One virtual session on a simulated clock.
SessionEnd sit(Study& study, const Protocol& protocol, StimulusBuilder& builder,
               const ProgramIdentity& program, const Sitting& sitting,
               const std::vector<ScriptedFault>& faults, const std::stop_token& stop,
               const DoneSink& done) {
  const std::optional<ParticipantRow> person = study.participant(sitting.participant);
  const StudyLock lock(study.folder(), Study::session_lock_name(sitting.participant));
  SteppedRig rig(rig_settings(protocol, faults), sitting.index);
  OpenSession session{};
  if (sitting.unfinished) {
    session = reopen(study, protocol, *sitting.unfinished);
    rig.move_clock_to(std::max(rig.clock().now_ns(), last_time_ns(session, study)));
  } else {
    SessionConditions conditions{};
    conditions.mode = SessionMode::simulate;
    conditions.seed = sitting.seed;
    conditions.counterbalance_row = sitting.counterbalance_row;
    conditions.pacing = rig.pacing();
    conditions.scheduling = rig.scheduling();
    conditions.device = rig.capability();
    conditions.started_utc = rig.clock().utc();
    conditions.clock_zero_ns = rig.clock().now_ns();
    conditions.observer_json = observer_json(protocol);
    session = begin_session(study, protocol, sitting.participant, conditions, program);
  }
  const Random random = Random(std::stoull(session.row.seed)).split("participant");
  VirtualParticipant participant(protocol, expectations_of(protocol, builder, random), *person,
                                 random);
  Conductor conductor(study, protocol, builder, rig, participant,
                      {.record = sitting.record, .done = done});
  const std::stop_callback on_stop(stop,
                                   [&conductor] { conductor.stop_after(Conductor::After::trial); });
  return conductor.run(std::move(session));
}

/// Sessions of a participant with this very protocol, in order.
std::vector<SessionRow> sessions_with(const Study& study, const std::string& participant,
                                      const Protocol& protocol) {
  std::vector<SessionRow> found{};
  for (const SessionRow& row : study.sessions()) {
    if (row.participant == participant &&
        study.protocol(row.protocol_id).source == protocol.source) {
      found.push_back(row);
    }
  }
  return found;
}

int first_free_number(const Study& study) {
  int number = 0;
  for (const ParticipantRow& person : study.participants()) {
    if (person.is_virtual && person.label.rfind("virtual", 0) == 0) {
      number = std::max(number, std::atoi(person.label.c_str() + 7));
    }
  }
  return number + 1;
}

}  // namespace

SimulationResult simulate(const SimulationInputs& inputs, const ModelRegistry& models,
                          const std::stop_token& stop, const std::function<void(double)>& progress,
                          const DoneSink& done) {
  const auto began = std::chrono::steady_clock::now();
  std::vector<Protocol> protocols{};
  for (const auto& file : inputs.protocols) {
    protocols.push_back(load_protocol(file, models, inputs.study));
  }
  for (const Protocol& protocol : protocols) hash_files(protocol, inputs.study);
  Study study = Study::exists(inputs.study)
                    ? Study::open(inputs.study, Access::read_write)
                    : Study::create(inputs.study, inputs.study.filename().string());
  study.mark_crashed_sessions();

  const Random random(inputs.seed);
  const int first = inputs.resume ? 1 : first_free_number(study);
  int sessions_each = 0;
  for (const Protocol& protocol : protocols) sessions_each += protocol.sessions;
  for (int i = 0; i < inputs.participants; ++i) {
    const std::int64_t first_sitting = std::int64_t{first + i - 1} * sessions_each;
    const ParticipantRow person =
        virtual_person(first + i, random, SimulatedClock(first_sitting).utc());
    if (!study.participant(person.label)) study.add_participant(person);
  }

  StimulusBuilder builder(models, inputs.study);
  const ProgramIdentity program = this_program();
  std::mutex mutex{};
  SimulationResult result{};
  std::string stopped_reason{};
  std::exception_ptr failure{};
  std::atomic<int> next{0};
  std::atomic<int> sessions_ended{0};
  const int total = inputs.participants * sessions_each;

  const auto take_through = [&](Study& own, int participant_index) {
    const int number = first + participant_index;
    const std::string label = virtual_person(number, random, "").label;
    int sitting_index = 0;
    for (std::size_t p = 0; p < protocols.size(); ++p) {
      const std::vector<SessionRow> before =
          inputs.resume ? sessions_with(own, label, protocols[p]) : std::vector<SessionRow>{};
      for (int repeat = 0; repeat < protocols[p].sessions; ++repeat, ++sitting_index) {
        if (stop.stop_requested()) return;
        Sitting sitting{};
        sitting.participant = label;
        sitting.index = std::int64_t{number - 1} * sessions_each + sitting_index;
        sitting.seed = random.split("session")
                           .split(static_cast<std::uint64_t>(number))
                           .split(static_cast<std::uint64_t>(sitting_index))
                           .bits();
        sitting.counterbalance_row = (number - 1) % counterbalance_rows(protocols[p]);
        sitting.record = inputs.recordings == Recordings::all ||
                         (inputs.recordings == Recordings::first && participant_index == 0);
        SessionEnd end{};
        if (static_cast<std::size_t>(repeat) < before.size()) {
          const SessionRow& row = before[static_cast<std::size_t>(repeat)];
          if (row.state != SessionState::completed) {
            sitting.unfinished = row;
            end = sit(own, protocols[p], builder, program, sitting, {}, stop, done);
          }
        } else {
          end = sit(own, protocols[p], builder, program, sitting, {}, stop, done);
        }
        const std::lock_guard lock(mutex);
        ++result.sessions;
        result.attempts += end.attempts;
        result.simulated_s += end.duration_s;
        if (end.state != SessionState::completed && !stop.stop_requested()) {
          stopped_reason = "the session of " + label + " with \"" + protocols[p].name +
                           "\" stopped: " + end.reason;
          next = inputs.participants;
          return;
        }
        if (progress) progress(static_cast<double>(++sessions_ended) / total);
      }
    }
  };
  const auto work = [&] {
    try {
      Study own = Study::open(inputs.study, Access::read_write);
      for (int i = next++; i < inputs.participants; i = next++) take_through(own, i);
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (!failure) failure = std::current_exception();
      next = inputs.participants;
    }
  };
  {
    std::vector<std::jthread> workers{};
    for (int job = 1; job < std::max(1, inputs.jobs); ++job) workers.emplace_back(work);
    work();
  }
  if (failure) std::rethrow_exception(failure);
  if (!stopped_reason.empty()) throw std::runtime_error(stopped_reason);
  if (stop.stop_requested()) {
    throw std::runtime_error(
        "stopped as asked; every finished trial is stored, go on with the same arguments and "
        "--resume");
  }
  result.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  return result;
}

namespace {

void wait_idly(double duration_s) {
  std::this_thread::sleep_for(std::chrono::duration<double>(duration_s));
}

/// Asks a person to agree to the protocol's statement; nothing is stored of one who does not.
void ask_consent(const Protocol& protocol, Respondent& respondent) {
  const Question question{.name = "consent",
                          .prompt = protocol.consent_statement + "\n\nDo you agree?",
                          .form = Question::Form::choice,
                          .options = {"yes", "no"}};
  if (respondent.answer(question, wait_idly) != "yes") {
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
    const std::string answer = respondent.answer(question, wait_idly);
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

}  // namespace

SessionEnd run_session(const RunInputs& inputs, const ModelRegistry& models, Respondent* respondent,
                       const std::stop_token& stop, const DoneSink& done) {
  if (const auto complaint = complaint_about_label(inputs.participant)) {
    throw std::runtime_error(*complaint);
  }
  const Protocol protocol = load_protocol(inputs.protocol, models, inputs.study);
  hash_files(protocol, inputs.study);
  Study study = Study::open(inputs.study, Access::read_write);
  study.mark_crashed_sessions();
  const StudyLock lock(inputs.study, Study::session_lock_name(inputs.participant));

  const std::optional<ParticipantRow> known = study.participant(inputs.participant);
  if (known && known->is_virtual != inputs.is_virtual) {
    throw std::runtime_error("participant " + inputs.participant + " is a " +
                             (known->is_virtual ? "virtual participant; use --virtual"
                                                : "person; --virtual is for virtual participants"));
  }
  StimulusBuilder builder(models, inputs.study);
  std::optional<OpenSession> open{};
  if (inputs.resume) open = resume_session(study, protocol, inputs.participant);
  const std::uint64_t seed = open ? std::stoull(open->row.seed) : inputs.seed;
  const Random random(seed);

  std::unique_ptr<Rig> rig{};
  if (inputs.pacing == RunPacing::stepped) {
    // Sittings of the same participant follow each other on the simulated calendar.
    std::int64_t index = 0;
    for (const SessionRow& row : study.sessions()) {
      if (row.pacing == "stepped") {
        index = std::max(index, row.clock_zero_ns / 3'600'000'000'000 + 1);
      }
    }
    if (open) index = open->row.clock_zero_ns / 3'600'000'000'000;
    auto stepped = std::make_unique<SteppedRig>(rig_settings(protocol, inputs.faults), index);
    if (open) {
      stepped->move_clock_to(std::max(stepped->clock().now_ns(), last_time_ns(*open, study)));
    }
    rig = std::move(stepped);
  } else {
    rig = std::make_unique<RealTimeRig>(rig_settings(protocol, inputs.faults), HandHabits{},
                                        random.split("hand"), Scheduling::fifo_if_permitted);
  }

  std::optional<std::string> consent_utc{};
  if (!inputs.is_virtual && !open && !protocol.consent_statement.empty()) {
    ask_consent(protocol, *respondent);
    consent_utc = rig->clock().utc();
  }
  std::unique_ptr<VirtualParticipant> stand_in{};
  ParticipantRow person{};
  if (known) {
    person = *known;
  } else if (inputs.is_virtual) {
    person = virtual_person(1, random, rig->clock().utc());
    person.label = inputs.participant;
  } else {
    person = ask_person(protocol, inputs.participant, *respondent, rig->clock().utc());
  }
  if (!known) study.add_participant(person);
  if (inputs.is_virtual) {
    const Random participant_random = random.split("participant");
    stand_in = std::make_unique<VirtualParticipant>(
        protocol, expectations_of(protocol, builder, participant_random), person,
        participant_random);
    respondent = stand_in.get();
  }
  if (!open) {
    SessionConditions conditions{};
    conditions.mode = inputs.is_virtual ? SessionMode::simulate : inputs.mode;
    conditions.seed = seed;
    conditions.pacing = rig->pacing();
    conditions.scheduling = rig->scheduling();
    conditions.device = rig->capability();
    conditions.started_utc = rig->clock().utc();
    conditions.clock_zero_ns = rig->clock().now_ns();
    conditions.consent_utc = consent_utc;
    if (inputs.is_virtual) conditions.observer_json = observer_json(protocol);
    open = begin_session(study, protocol, inputs.participant, conditions, this_program());
  }
  Conductor conductor(study, protocol, builder, *rig, *respondent, {.record = true, .done = done});
  const std::stop_callback on_stop(stop,
                                   [&conductor] { conductor.stop_after(Conductor::After::trial); });
  return conductor.run(std::move(*open));
}

}  // namespace asperity
