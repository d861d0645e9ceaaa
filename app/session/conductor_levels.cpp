// The part of Conductor that obtains levels from an external program.

#include <chrono>
#include <string>

#include <nlohmann/json.hpp>

#include "app/session/conductor.h"
#include "app/session/levels/level_messages.h"
#include "app/session/levels/level_program.h"
#include "app/session/trial_outcome.h"
#include "app/words/coded_phrases.h"
#include "app/words/event_kinds.h"
#include "app/words/reason.h"

namespace asperity {

namespace {

constexpr double kToEnd_s = 2.0;  // after the end of its input a program may store what it knows

/// Relative to the folder of the study.
std::string log_of_program(const SessionRow& session) {
  const std::string number = std::to_string(session.session);
  return "logs/" + session.participant + "/session-" + (number.size() < 2 ? "0" : "") + number +
         "_external.log";
}

}  // namespace

/// Has the external program state what the plan requests, and stores each statement before what follows from it.
void Conductor::supply_levels() {
  if (!session_.course->requested()) {
    // Its input ends with its block, not with the session.
    if (session_.course->awaited() == nullptr ||
        session_.course->awaited()->block_ordinal != block_of_program_) {
      end_program();
    }
    return;
  }
  while (!stopped_ && session_.course->requested()) {
    if (requests_.take_stop(StopAfter::trial)) return stop(phrase_of(Reason::as_asked_after_trial));
    std::optional<SuppliedStep> step{};
    try {
      step = stated_step();
    } catch (const PhrasedError& failure) {
      level_program_.reset();
      wait_out_program(failure.said());
      continue;
    }
    if (!step) return;  // the session is to end
    course_.event(kExternalLevel, "", json_of(*step));
    const std::size_t before = plan().trials.size();
    session_.course->supply(step->step);
    store_trials(before);
    note_matches();
  }
  progress_->extend();
  course_.set_plan(plan());
  show_progress();
}

/// Starts the program where it does not run, and waits for its statement. Nothing where the session is to end meanwhile.
std::optional<SuppliedStep> Conductor::stated_step() {
  const LevelRequest& request = session_.course->requested().value();
  if (block_of_program_ != request.block_ordinal) end_program();
  if (!level_program_) {
    const ExternalProgram& program = settings_.level_program.value();
    const std::string log = log_of_program(session_.row);
    auto data = nlohmann::ordered_json::parse(provenance_json(program));
    data["block_ordinal"] = request.block_ordinal;
    data["log"] = log;
    level_program_ = std::make_unique<LevelProgram>(
        program, begin_line(protocol_, session_.row, request), study_.folder() / log);
    block_of_program_ = request.block_ordinal;
    course_.event(kExternalProgram, program.name(), data.dump());
  }
  level_program_->ask(request);
  const bool is_stepped = rig_.pacing() == "stepped";
  for (;;) {
    // A simulated clock stands still meanwhile: the program must not change the times that are stored.
    if (!is_stepped) course_.pass_slice();
    std::optional<SuppliedStep> step =
        level_program_->step(is_stepped ? SessionCourse::kSlice_s : 0.0);
    if (step) return step;
    if (const auto reason = requests_.take_abort()) {
      stop(*reason);
      return std::nullopt;
    }
    if (requests_.take_stop(StopAfter::trial)) {
      stop(phrase_of(Reason::as_asked_after_trial));
      return std::nullopt;
    }
  }
}

/// Tells the program the outcome of a trial as soon as it is stored.
void Conductor::tell_program(const Trial& trial, const AttemptRow& attempt) {
  if (!level_program_ || !trial.track || trial.block_ordinal != block_of_program_) return;
  const std::optional<LevelAnswer> answer = level_answer_of(protocol_, trial, attempt);
  if (answer) level_program_->tell({.of = *trial.track, .answer = *answer});
}

/// Closes the input of the program and waits until it has ended; one that does not end is ended. It has stated what it
/// was asked: a failure is stored, and changes nothing for the session.
void Conductor::end_program() {
  if (!level_program_) return;
  level_program_->close();
  const bool is_stepped = rig_.pacing() == "stepped";
  const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(kToEnd_s);
  while (!level_program_->has_ended() && std::chrono::steady_clock::now() < until) {
    if (!is_stepped) course_.pass_slice();
    level_program_->attend(is_stepped ? SessionCourse::kSlice_s : 0.0);
  }
  try {
    level_program_->require_kept_errors();
  } catch (const PhrasedError& failure) {
    course_.event(kExternalFailure, failure.said().english());
  }
  level_program_.reset();
}

/// Holds the session until the experimenter has the program started again, or stops the session.
void Conductor::wait_out_program(const Phrase& failure) {
  // The sentence is stored as it is: it quotes what the program wrote.
  const Phrase reason = phrase_of(Reason::external_program_failed).with(failure.english());
  course_.event(kExternalFailure, reason);
  if (!settings_.links.experimenter_is_there) return stop(reason);
  const SessionPhase before = course_.phase();
  requests_.pause();
  const Phrase what =
      phrase("Troubles",
             "%1 The session is paused; every completed trial is stored. Fix the problem, then "
             "resume: the program is started again and receives the responses so far.")
          .with(failure.as_sentence());
  publish_trouble(what, SessionTrouble::Remedy::resume);
  begin_pause();
  respondent_.hear_of_fault(what.english());
  while (!stopped_ && requests_.is_paused()) {
    course_.pass_slice();
    course_.store_remarks();
    const Respondent::AfterFault wish = respondent_.after_fault();
    if (wish == Respondent::AfterFault::go_on) requests_.resume();
    if (const auto abort = requests_.take_abort()) {
      stop(*abort);
    } else if (wish == Respondent::AfterFault::end || requests_.take_stop(StopAfter::trial) ||
               requests_.take_stop(StopAfter::block)) {
      stop(reason);
    }
  }
  if (stopped_) return;
  end_pause(before);
}

}  // namespace asperity
