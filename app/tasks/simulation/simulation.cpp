// Divides the participants among threads, and recognises the batch of an interrupted simulation.

#include "app/tasks/simulation/simulation.h"

#include <algorithm>
#include <atomic>
#include <charconv>
#include <chrono>
#include <exception>
#include <map>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <thread>

#include <nlohmann/json.hpp>

#include "analysis/words/phrase.h"
#include "app/profiles/device_kind.h"
#include "app/session/respondents/virtual_participant.h"
#include "app/session/session_compute.h"
#include "app/session/session_setup.h"
#include "app/tasks/protocol_files.h"
#include "app/tasks/session_run.h"
#include "app/tasks/warnings/plugin_warnings.h"
#include "app/tasks/warnings/session_warnings.h"
#include "app/tasks/warnings/stimulus_warnings.h"
#include "app/words/phrase_of_error.h"
#include "device/simulated_models.h"
#include "protocols/plan/groups.h"

namespace asperity {

namespace {

constexpr std::string_view kLabel = "virtual";

/// Identifies the participants of one simulation; stored with each of them, so that an interrupted
/// simulation can be recognised.
struct Batch {
  std::uint64_t seed = 0;
  int first = 1;
  int participants = 0;
  bool operator==(const Batch&) const = default;
};

std::string with_batch(const std::string& answers_json, const Batch& batch) {
  nlohmann::ordered_json answers = nlohmann::ordered_json::parse(answers_json);
  answers["simulation_seed"] = std::to_string(batch.seed);
  answers["simulation_first"] = batch.first;
  answers["simulation_participants"] = batch.participants;
  return answers.dump();
}

std::optional<Batch> batch_of(const ParticipantRow& person) {
  const auto answers = nlohmann::json::parse(person.answers_json, nullptr, false);
  if (!answers.is_object() || !answers.contains("simulation_seed")) return {};
  return Batch{std::stoull(answers.value("simulation_seed", "0")),
               answers.value("simulation_first", 1), answers.value("simulation_participants", 0)};
}

int number_in_label(const std::string& label) {
  int number = 0;
  if (label.rfind(kLabel, 0) == 0) {
    std::from_chars(label.data() + kLabel.size(), label.data() + label.size(), number);
  }
  return number;
}

/// The virtual participants in a study, including deleted ones.
struct Batches {
  std::optional<Batch> begun{};  ///< the latest of the same seed and number of participants
  int of_seed = 0;               ///< participants of simulations with the same seed
  int asked_of_seed = 0;         ///< the requested number of the latest of these simulations
  int largest_number = 0;    ///< at least that of every virtual participant, deleted ones included
  int deleted = 0;           ///< virtual participants of whom only the deletion is recorded
  bool any_virtual = false;  ///< deleted ones included
};

Batches batches_in(const Study& study, const SimulationInputs& inputs) {
  Batches there{};
  for (const WithdrawalRow& withdrawal : study.withdrawals()) {
    if (withdrawal.is_virtual && withdrawal.data == WithdrawnData::deleted) ++there.deleted;
  }
  int virtual_people = 0;
  for (const ParticipantRow& person : study.participants()) {
    there.largest_number = std::max(there.largest_number, number_in_label(person.label));
    if (person.is_virtual) ++virtual_people;
    const std::optional<Batch> batch = batch_of(person);
    if (!batch) continue;
    there.largest_number = std::max(there.largest_number, batch->first + batch->participants - 1);
    if (batch->seed != inputs.seed) continue;
    ++there.of_seed;
    there.asked_of_seed = batch->participants;
    if (batch->participants == inputs.participants) there.begun = batch;  // labels are in order
  }
  // Numbers are assigned in order from 1, so that none is larger than the number of participants
  // added. Assigning a number twice would recreate the deleted participant: with the same seed, the
  // same responses.
  there.largest_number = std::max(there.largest_number, virtual_people + there.deleted);
  there.any_virtual = virtual_people + there.deleted > 0;
  return there;
}

std::string deleted_text(int deleted) {
  if (deleted == 0) return "";
  const std::string number = deleted == 1 ? "1 virtual participant was"
                                          : std::to_string(deleted) + " virtual participants were";
  return " (" + number +
         " deleted from the study; the simulation to which they belonged is not stored)";
}

/// The batch to add, or the one to resume.
Batch choose_batch(const Batches& there, const SimulationInputs& inputs) {
  if (!inputs.resume) return {inputs.seed, there.largest_number + 1, inputs.participants};
  if (there.begun) return *there.begun;
  if (!there.any_virtual) return {inputs.seed, 1, inputs.participants};
  throw std::runtime_error(
      "there is nothing to resume in " + inputs.study.string() +
      ": the study has no participant of a simulation with --participants " +
      std::to_string(inputs.participants) + " and --seed " + std::to_string(inputs.seed) +
      deleted_text(there.deleted) +
      (there.of_seed > 0 ? "; with this seed it has a simulation with --participants " +
                               std::to_string(there.asked_of_seed) + ": resume it with this number"
                         : std::string("; leave out --resume to begin this simulation")));
}

/// Sessions of a participant with exactly this protocol, in order.
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

/// Whether the participant is in the study, and not withdrawn.
bool takes_part(const Study& study, const std::string& label) {
  const std::optional<ParticipantRow> person = study.participant(label);
  return person && !person->withdrawn;
}

/// The state shared by all jobs.
class Simulation final {
 public:
  Simulation(const SimulationInputs& inputs, const ModelRegistry& models, std::stop_token stop,
             const std::function<void(double)>& progress,
             const std::function<void(const AttemptDone&)>& done)
      : inputs_(inputs),
        random_(inputs.seed),
        builder_(models, inputs.study),
        stop_(std::move(stop)),
        progress_(progress),
        done_(done) {
    const std::optional<SimulatedDeviceSettings> device = simulated_settings(inputs.device);
    if (device) builder_.assume_position_step(device->sensor.position_step_m);
    bool is_used = !inputs.level_program;
    for (const auto& file : inputs.protocols) {
      protocols_.push_back(load_protocol_to_run(file, inputs.study, builder_));
      sessions_each_ += protocols_.back().sessions;
      const Protocol& protocol = protocols_.back();
      is_used = is_used || !blocks_of_external_program(protocol).empty();
      require_program(protocol, program_for(protocol));
    }
    // No protocol takes levels from it.
    if (!is_used) require_program(protocols_.back(), inputs.level_program);
    if (is_on_gpu()) {
      for (const Protocol& protocol : protocols_) require_two_bodies(protocol, models);
      builder_.compute_on(compute_on_simulated_clock());
    }
  }

  SimulationResult run();

 private:
  /// All protocols share the models.
  bool is_on_gpu() const {
    if (inputs_.on_gpu) return *inputs_.on_gpu;
    const bool first = protocols_.front().computes_on_gpu;
    for (const Protocol& protocol : protocols_) {
      if (protocol.computes_on_gpu == first) continue;
      throw PhrasedError(
          phrase("Simulation",
                 "the protocols %1 and %2 differ in device.compute; state --compute, or simulate "
                 "them one after the other")
              .with(protocols_.front().name, protocol.name));
    }
    return first;
  }
  /// Nothing for a protocol that has no use for the program.
  std::optional<ExternalProgram> program_for(const Protocol& protocol) const {
    return blocks_of_external_program(protocol).empty() ? std::nullopt : inputs_.level_program;
  }
  /// Whether the participant with this number in the batch, from 0, is of this shard.
  bool is_included(int in_batch) const {
    return !inputs_.shard || inputs_.shard->has(static_cast<std::size_t>(in_batch));
  }
  void prepare(Study& study);
  void check_sessions(const Study& study) const;
  bool is_interrupted(const Study& study, const Batch& batch) const;
  std::uint64_t seed_of(int number, int session_index) const;
  void work();
  void take_through(Study& study, int number);
  bool keeps_recordings(int number) const;
  void check_recordings(const Study& study) const;
  void report_sessions(int done);
  void hold(Study& study, const ParticipantRow& person, const Protocol& protocol,
            std::int64_t calendar_index, std::uint64_t seed, std::optional<SessionRow> unfinished);

  const SimulationInputs& inputs_;
  Random random_;
  std::vector<Protocol> protocols_{};
  int sessions_each_ = 0;
  StimulusBuilder builder_;
  ProgramIdentity program_ = this_program();
  Batch batch_{};
  std::stop_token stop_;
  const std::function<void(double)>& progress_;
  const std::function<void(const AttemptDone&)>& done_;
  std::atomic<int> next_{0};
  std::mutex mutex_{};  // guards the following members
  SimulationResult result_{};
  int sessions_seen_ = 0;
  std::exception_ptr failure_{};
};

std::uint64_t Simulation::seed_of(int number, int session_index) const {
  return random_.split("session")
      .split(static_cast<std::uint64_t>(number))
      .split(static_cast<std::uint64_t>(session_index))
      .bits();
}

/// Before anything is written: every existing session has to belong to this simulation.
void Simulation::check_sessions(const Study& study) const {
  for (std::size_t i = 0; i < protocols_.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (protocols_[i].source == protocols_[j].source) {
        throw std::runtime_error(
            "the protocol \"" + protocols_[i].name +
            "\" is given twice; give it once: the number of its sessions is set in the protocol");
      }
    }
  }
  for (int i = 0; i < batch_.participants; ++i) {
    const int number = batch_.first + i;
    const std::string label = virtual_person(number, random_, "").label;
    int session_index = 0;
    for (const Protocol& protocol : protocols_) {
      const std::vector<SessionRow> before = sessions_with(study, label, protocol);
      for (std::size_t repeat = 0; repeat < static_cast<std::size_t>(protocol.sessions);
           ++repeat, ++session_index) {
        if (repeat >= before.size() ||
            before[repeat].seed == std::to_string(seed_of(number, session_index))) {
          continue;
        }
        throw std::runtime_error("session " + std::to_string(before[repeat].session) + " of " +
                                 label +
                                 " was not begun with these protocols in this order; nothing was "
                                 "written. Name the same protocols in the same order");
      }
    }
  }
}

bool Simulation::keeps_recordings(int number) const {
  return inputs_.recordings == Recordings::all ||
         (inputs_.recordings == Recordings::first && number == batch_.first);
}

/// The value of --recordings is not stored; the attempts of the first participant and of another one show it. Continued with
/// another value, a study would have the records of some sessions or trials only.
void Simulation::check_recordings(const Study& study) const {
  bool has_checked_first = false;
  bool has_checked_other = false;
  for (const SessionRow& row : study.sessions()) {
    const int number = number_in_label(row.participant);
    bool& has_checked = number == batch_.first ? has_checked_first : has_checked_other;
    const bool is_recording =
        std::any_of(protocols_.begin(), protocols_.end(), [&](const Protocol& protocol) {
          return protocol.record && study.protocol(row.protocol_id).source == protocol.source;
        });
    if (has_checked || !is_recording || number < batch_.first ||
        number >= batch_.first + batch_.participants) {
      continue;
    }
    const std::vector<AttemptRow> attempts = study.attempts(row.id);
    if (attempts.empty()) continue;
    has_checked = true;
    const bool has_records =
        std::any_of(attempts.begin(), attempts.end(),
                    [](const AttemptRow& attempt) { return attempt.recording.has_value(); });
    if (has_records == keeps_recordings(number)) continue;
    throw std::runtime_error(
        "the tick records of " + row.participant + " were " + (has_records ? "kept" : "not kept") +
        " when the simulation in " + inputs_.study.string() +
        " was begun, contrary to the present --recordings; nothing was written. "
        "Resume with the value of --recordings with which it was begun");
  }
}

/// Whether a batch has begun with these protocols, or with none, and has not completed all of their
/// sessions. A withdrawn participant has nothing left to do.
bool Simulation::is_interrupted(const Study& study, const Batch& batch) const {
  const std::vector<SessionRow> sessions = study.sessions();
  bool has_begun = false;
  bool has_sessions = false;
  bool is_complete = true;
  for (int i = 0; i < batch.participants; ++i) {
    const std::string label = virtual_person(batch.first + i, random_, "").label;
    if (!takes_part(study, label)) continue;
    has_sessions = has_sessions ||
                   std::any_of(sessions.begin(), sessions.end(), [&label](const SessionRow& row) {
                     return row.participant == label;
                   });
    for (const Protocol& protocol : protocols_) {
      const std::vector<SessionRow> done = sessions_with(study, label, protocol);
      has_begun = has_begun || !done.empty();
      is_complete = is_complete && done.size() >= static_cast<std::size_t>(protocol.sessions) &&
                    std::all_of(done.begin(), done.end(), [&](const SessionRow& row) {
                      return has_ended(study, protocol, row);
                    });
    }
  }
  return !is_complete && (has_begun || !has_sessions);
}

void Simulation::prepare(Study& study) {
  const Batches there = batches_in(study, inputs_);
  if (!inputs_.resume && there.begun && is_interrupted(study, *there.begun)) {
    throw PhrasedError(phrase("Simulation",
                              "the simulation in %3 (participants: %1, seed: %2) is not complete; "
                              "to complete it, add --resume; to add further participants, use "
                              "another --seed. No participant was added")
                           .with(std::to_string(inputs_.participants), std::to_string(inputs_.seed),
                                 inputs_.study.string()));
  }
  study.mark_crashed_sessions();
  batch_ = choose_batch(there, inputs_);
  check_sessions(study);
  if (inputs_.resume) check_recordings(study);
  for (std::size_t i = 0; i < protocols_.size() && inputs_.warned; ++i) {
    const CheckedProtocol checked(protocols_[i], inputs_.protocols[i].string());
    if (const auto warning = warning_about_version(checked.protocol, checked.file_name, study)) {
      inputs_.warned(*warning);
    }
    std::vector<Diagnostic> warnings =
        warnings_about_plugins(checked, study, builder_.models(), SessionMode::simulate);
    append(warnings, warnings_about_stimuli(checked, builder_, {.stop = stop_}));
    for (const Diagnostic& warning : warnings) inputs_.warned(warning);
  }
  if (there.begun == batch_) return;
  if (there.of_seed > 0 && inputs_.noticed) {
    inputs_.noticed(
        {.there = there.of_seed,
         .first = virtual_person(batch_.first, random_, "").label,
         .last = virtual_person(batch_.first + batch_.participants - 1, random_, "").label});
  }
  std::vector<ParticipantRow> added{};
  for (int i = 0; i < batch_.participants; ++i) {
    if (!is_included(i)) continue;
    const std::int64_t first_session = std::int64_t{batch_.first + i - 1} * sessions_each_;
    ParticipantRow person =
        virtual_person(batch_.first + i, random_, SimulatedClock(first_session).utc());
    person.answers_json = with_batch(person.answers_json, batch_);
    added.push_back(std::move(person));
  }
  study.add_participants(added);
}

SimulationResult Simulation::run() {
  const auto began = std::chrono::steady_clock::now();
  {
    Study study = Study::exists(inputs_.study)
                      ? Study::open(inputs_.study, Access::read_write)
                      : Study::create(inputs_.study, inputs_.study.filename().string());
    prepare(study);
  }
  {
    std::vector<std::jthread> workers{};
    for (int job = 1; job < std::max(1, inputs_.jobs); ++job) {
      workers.emplace_back([this] { work(); });
    }
    work();
  }
  if (failure_) std::rethrow_exception(failure_);
  if (stop_.stop_requested()) {
    if (inputs_.shard) {
      throw std::runtime_error("shard " + text_of(*inputs_.shard) +
                               " was stopped on request and is not stored; repeat the command to "
                               "simulate it");
    }
    throw PhrasedError(
        inputs_.resume
            ? phrase("Simulation",
                     "the simulation was stopped on request; every completed trial is stored; "
                     "to resume it, start it again with the same arguments")
            : phrase("Simulation",
                     "the simulation was stopped on request; every completed trial is stored; "
                     "to resume it, add --resume to the same arguments"));
  }
  result_.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  return result_;
}

void Simulation::work() {
  try {
    Study study = Study::open(inputs_.study, Access::read_write);
    for (int i = next_++; i < batch_.participants && !stop_.stop_requested(); i = next_++) {
      if (is_included(i)) take_through(study, batch_.first + i);
    }
  } catch (...) {
    next_ = batch_.participants;
    const std::lock_guard lock(mutex_);
    if (!failure_) failure_ = std::current_exception();
  }
}

void Simulation::take_through(Study& study, int number) {
  const std::optional<ParticipantRow> found =
      study.participant(virtual_person(number, random_, "").label);
  if (!found || found->withdrawn) {
    report_sessions(sessions_each_);
    return;
  }
  const ParticipantRow& person = *found;
  int session_index = 0;
  for (const Protocol& protocol : protocols_) {
    const std::vector<SessionRow> before = sessions_with(study, person.label, protocol);
    for (std::size_t repeat = 0; repeat < static_cast<std::size_t>(protocol.sessions);
         ++repeat, ++session_index) {
      if (stop_.stop_requested()) return;
      const std::uint64_t seed = seed_of(number, session_index);
      const std::int64_t index = std::int64_t{number - 1} * sessions_each_ + session_index;
      const std::optional<SessionRow> row =
          repeat < before.size() ? std::optional(before[repeat]) : std::nullopt;
      if (!row || !has_ended(study, protocol, *row)) {
        hold(study, person, protocol, index, seed, row);
      }
      report_sessions(1);
    }
  }
}

void Simulation::report_sessions(int done) {
  const std::lock_guard lock(mutex_);
  sessions_seen_ += done;
  // A study that is complete already has no progress.
  if (progress_ && result_.sessions > 0) {
    const int participants = inputs_.shard ? static_cast<int>(inputs_.shard->number_of(
                                                 static_cast<std::size_t>(batch_.participants)))
                                           : batch_.participants;
    progress_(static_cast<double>(sessions_seen_) / (participants * sessions_each_));
  }
}

void Simulation::hold(Study& study, const ParticipantRow& person, const Protocol& protocol,
                      std::int64_t calendar_index, std::uint64_t seed,
                      std::optional<SessionRow> unfinished) {
  const int number = number_in_label(person.label);
  SessionRun session_run{};
  session_run.participant = person;
  session_run.mode = SessionMode::simulate;
  session_run.seed = seed;
  const Allocation allocation = allocation_in_turn(protocol, number - 1);
  session_run.counterbalance_row = allocation.counterbalance_row;
  if (protocol.groups) session_run.group = allocation.group;
  session_run.record = keeps_recordings(number);
  session_run.level_program = program_for(protocol);
  const StudyLock lock(study.folder(), Study::session_lock_name(person.label));
  SteppedRig rig(rig_settings_for(protocol, {}, inputs_.device), calendar_index);
  if (unfinished) {
    rig.move_clock_to(std::max(rig.clock().now_ns(), last_time_ns(study, *unfinished)));
    session_run.unfinished = std::move(unfinished);
  }
  const SessionEnd end =
      run_on_rig(study, protocol, builder_, program_, session_run, rig, nullptr, stop_, done_);
  if (end.state != SessionState::completed && !end.as_the_protocol_says &&
      !stop_.stop_requested()) {
    if (inputs_.shard) {
      throw std::runtime_error("the session of " + person.label + " with \"" + protocol.name +
                               "\" stopped: " + end.reason.english() + "; shard " +
                               text_of(*inputs_.shard) +
                               " is not stored; repeat the command to simulate it");
    }
    throw SimulationStopped(phrase("Simulation",
                                   "the session of %1 with \"%2\" stopped: %3; every completed "
                                   "trial is stored")
                                .with(person.label, protocol.name, end.reason));
  }
  const std::lock_guard result_lock(mutex_);
  ++result_.sessions;
  result_.attempts += end.attempts;
  result_.simulated_s += end.duration_s;
}

}  // namespace

SimulationResult simulate(const SimulationInputs& inputs, const ModelRegistry& models,
                          const std::stop_token& stop, const std::function<void(double)>& progress,
                          const std::function<void(const AttemptDone&)>& done) {
  require_virtual_hand_on(inputs.device);
  return Simulation(inputs, models, stop, progress, done).run();
}

}  // namespace asperity
