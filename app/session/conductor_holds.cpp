// The part of Conductor that suspends a session: pauses, repetitions, lost noise, faults.

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/session/conductor.h"
#include "app/words/coded_phrases.h"
#include "app/words/reason.h"

namespace asperity {

namespace {

constexpr double kCheck_s = 0.2;  // longer than a surface takes to fade out
// A machine that stops this often will stop again.
constexpr int kMostStandstills = 3;

/// The phase of a session after a fault: the attempt that the fault ended is over.
SessionPhase after_fault(SessionPhase before) {
  const bool in_attempt = before == SessionPhase::fore || before == SessionPhase::contact ||
                          before == SessionPhase::response;
  return in_attempt ? SessionPhase::iti : before;
}

/// The message of a plug-in that failed, which is part of the sentence; empty for other faults.
std::string message_of_plugin(const Phrase& sentence) {
  const char* const code = sentence.code();
  if (code != nullptr && std::string_view(code) == phrase_of(Reason::plugin_failed).code()) {
    return sentence.english();
  }
  for (const Phrase& part : sentence.arguments()) {
    if (std::string message = message_of_plugin(part); !message.empty()) return message;
  }
  return {};
}

std::string data_of_fault(const Phrase& sentence) {
  const std::string message = message_of_plugin(sentence);
  // Otherwise the fault states everything.
  return message.empty() ? "null" : nlohmann::ordered_json{{"reason", message}}.dump();
}

}  // namespace

// --- pauses and repeats --------------------------------------------------------------------------

void Conductor::repeat_as_asked() {
  while (!stopped_) {
    const std::optional<Phrase> reason = requests_.take_repeat();
    if (!reason) return;
    repeat_last(*reason);
  }
}

bool Conductor::between_steps(Next next) {
  for (bool repeated = false;; repeated = true) {
    course_.store_remarks();
    hold(next);
    if (stopped_) return repeated;
    const std::optional<Phrase> reason = requests_.take_repeat();
    if (!reason) return repeated;
    repeat_last(*reason);
  }
}

void Conductor::repeat_last(const Phrase& reason) {
  if (is_refreshing_) {
    course_.event("repeat_refused", phrase_of(Reason::practice_is_repeated));
    return;
  }
  const AttemptRow* last = tally_->last_done();
  if (last == nullptr) {
    course_.event("repeat_refused", phrase_of(Reason::nothing_to_repeat));
    return;
  }
  const int trial = last->trial;
  const int attempt = last->attempt;
  study_.set_aside(session_.row.id, trial, attempt, stored(reason));
  tally_->set_aside(trial, attempt, stored(reason));
  course_.event("trial_repeated", reason,
                nlohmann::ordered_json{{"trial", trial}, {"attempt", attempt}}.dump());
  progress_->set_aside(*last);
  show_progress();
  ask_again(plan().trials.at(static_cast<std::size_t>(trial - 1)));
}

/// Repeats an invalidated trial. After its block is over, the end of the block does not ask it
/// again if a further attempt is needed.
void Conductor::ask_again(const Trial& trial) {
  do {
    run_trial(trial);
  } while (!stopped_ && trial.block_ordinal != block_ && !tally_->is_done(trial));
}

/// Returns when the next step can begin: no pause, no fault, no lost noise.
void Conductor::hold(Next next) {
  const SessionPhase before = course_.phase();
  const bool is_attended = settings_.links.experimenter_is_there;
  bool paused = false;
  while (!stopped_) {
    if (const auto reason = requests_.take_abort()) {
      stop(*reason);
      return;
    }
    const ServoStatus status = rig_.loop().status();
    if (status.fault != Fault::none && (is_attended || status.fault == Fault::standstill) &&
        !wait_out_fault(fault_sentence(interruption_by(status), {}))) {
      return;
    }
    if (is_attended && next == Next::trial && course_.has_lost_noise() && !requests_.is_paused()) {
      pause_without_noise();
    }
    if (!requests_.is_paused()) break;
    if (!paused) begin_pause();
    paused = true;
    if (requests_.take_stop(StopAfter::trial)) {
      stop(phrase_of(Reason::as_asked));
      return;
    }
    course_.pass_slice();
    course_.store_remarks();
  }
  if (!paused || stopped_) return;
  end_pause(before);
}

void Conductor::begin_pause() {
  course_.event("paused", "");
  course_.enter(SessionPhase::paused);
  course_.show({.kind = ParticipantScene::Kind::paused});
  course_.play(Cue::paused);
}

/// Returns to the phase in which the pause began.
void Conductor::end_pause(SessionPhase before) {
  course_.event("resumed", "");
  course_.update([](SessionSnapshot& snapshot) { snapshot.trouble.reset(); });
  course_.enter(before);
  course_.show({});
}

void Conductor::pause_without_noise() {
  requests_.pause();
  publish_trouble(course_.has_masked()
                      ? phrase("Troubles",
                               "The masking noise has stopped, and the session is paused. Fix the "
                               "problem with the sound, then resume.")
                      : phrase("Troubles",
                               "The masking noise cannot start: the sound card does not play. The "
                               "session is paused. Fix the problem with the sound, then resume."),
                  SessionTrouble::Remedy::resume);
  course_.event(course_.has_masked() ? "masking_noise_lost" : "masking_noise_missing", "");
}

// --- faults --------------------------------------------------------------------------------------

/// Checks the device while nothing is rendered: it has to respond at the servo's rate and accept
/// zero force.
void Conductor::check_device() {
  const Phrase problem = device_problem([this](double duration_s) { course_.wait(duration_s); });
  if (!problem.empty()) {
    throw Interruption{AttemptOutcome::device_fault, phrase_of(Reason::not_ready).with(problem)};
  }
}

/// What is wrong with the device, as part of a sentence; empty when there is no problem.
Phrase Conductor::device_problem(const Wait& waiting) {
  return problem_in(records_without_surface(kCheck_s, waiting));
}

std::vector<TickRecord> Conductor::records_without_surface(double duration_s, const Wait& waiting) {
  rig_.loop().withdraw();
  Recorder& recorder = course_.recorder();
  recorder.begin(nullptr, protocol_.rate_Hz, rig_.records());
  waiting(duration_s);
  return recorder.finish(rig_.records()).records;
}

Phrase Conductor::problem_in(const std::vector<TickRecord>& records) {
  if (records.empty()) return phrase_of(Reason::does_not_tick);
  if (records.back().has(TickFlag::device_lost)) return phrase_of(Reason::does_not_answer);
  if (records.back().sent.force_N != glm::dvec3{0.0}) return phrase_of(Reason::sends_force);
  return {};
}

/// Whether the step interrupted outside an attempt is started again: waits out a fault with an experimenter,
/// or a standstill. False at once for other interruptions. The wait may end the session.
bool Conductor::outlives(const Interruption& interruption) {
  if (!is_fault(interruption.outcome) ||
      !(settings_.links.experimenter_is_there || interruption.fault == Fault::standstill)) {
    return false;
  }
  wait_out_fault(fault_sentence(interruption, {}));
  return true;
}

/// A standstill is over when the loop detects it, and requires no action by a user: the fault is
/// cleared and the device checked. Returns nothing when that has succeeded, otherwise the sentence
/// that states the problem; `what` is the one of the standstill.
std::optional<Phrase> Conductor::trouble_after_standstill(const Phrase& what) {
  const TickProgress before = rig_.loop().progress();
  const auto hangs = [&] { return rig_.loop().progress().hangs_since(before); };
  // Not cleared while the tick is under way: it would send the force of the position that it has read before.
  constexpr double kSlice_s = SessionCourse::kSlice_s;
  for (double passed_s = 0.0; hangs() && passed_s < kCheck_s; passed_s += kSlice_s) {
    unheeding_(kSlice_s);
  }
  if (hangs()) return with_semicolon(what, phrase_of(Reason::restart_program));
  rig_.clear_fault(Fault::standstill);
  const Phrase problem = device_problem(unheeding_);
  const ServoStatus status = rig_.loop().status();
  if (status.fault != Fault::none) return fault_sentence(interruption_by(status), {});
  if (!problem.empty()) {
    return phrase_of(Reason::failed_between_trials)
        .with(phrase_of(Reason::not_ready).with(problem));
  }
  forget_surface();
  course_.event("fault_cleared", "");
  publish_trouble(
      phrase("Troubles",
             "The servo loop stalled for more than 50 ms: the force was set to zero, and the "
             "interrupted step is repeated. At the third occurrence the session stops."),
      SessionTrouble::Remedy::none);
  return {};
}

/// A surface that was presented when a fault came is no longer felt.
void Conductor::forget_surface() {
  while (rig_.loop().collect().renderer != nullptr) {
  }
}

bool Conductor::wait_out_fault(Phrase what) {
  const TickProgress at_fault = rig_.loop().progress();
  if (rig_.loop().status().fault == Fault::standstill) {
    course_.event("fault", name_of(Fault::standstill));
    if (++standstills_ == kMostStandstills) {
      stop(phrase_of(Reason::stood_still).with(std::to_string(standstills_)));
      return false;
    }
    std::optional<Phrase> trouble = trouble_after_standstill(what);
    if (!trouble) return true;
    what = *std::move(trouble);
  }
  if (!settings_.links.experimenter_is_there) {
    stop(what);
    return false;
  }
  const SessionPhase before = after_fault(course_.phase());
  requests_.take_clear_fault();  // one requested before this fault
  course_.event("fault", name_of(rig_.loop().status().fault), data_of_fault(what));
  course_.enter(SessionPhase::fault);
  course_.show({.kind = ParticipantScene::Kind::paused});
  course_.play(Cue::paused);
  const auto stopped = [&] {
    const TickProgress now = rig_.loop().progress();
    if (rig_.loop().status().fault == Fault::standstill && now.hangs_since(at_fault) &&
        !now.rendering) {
      return phrase("Troubles",
                    "%1 Zero force was requested, but the driver does not respond: if the handle "
                    "still exerts a force, switch the device off.")
          .with(what.as_sentence());
    }
    const bool by_hand = rig_.loop().status().fault == Fault::emergency_stop;
    return (by_hand ? phrase("Troubles", "%1 The force is zero until the stop is cleared.")
                    : phrase("Troubles", "%1 The force is zero until the fault is cleared."))
        .with(what.as_sentence());
  };
  const auto tell = [this](const Phrase& sentence) {
    publish_trouble(sentence, SessionTrouble::Remedy::clear_fault);
    respondent_.hear_of_fault(sentence.english());
  };
  tell(stopped());
  for (;;) {
    course_.pass_slice();
    course_.store_remarks();
    if (const auto reason = requests_.take_abort()) {
      stop(*reason);
      return false;
    }
    const Respondent::AfterFault wish = respondent_.after_fault();
    if (wish == Respondent::AfterFault::end || requests_.take_stop(StopAfter::trial) ||
        requests_.take_stop(StopAfter::block)) {
      stop(what);
      return false;
    }
    if (wish == Respondent::AfterFault::go_on) requests_.clear_fault();
    if (!requests_.lift_fault(rig_.loop().status().fault)) continue;
    const Phrase problem = device_problem(unheeding_);
    if (problem.empty() && rig_.loop().status().fault == Fault::none) break;
    const ServoStatus status = rig_.loop().status();
    tell(status.fault == Fault::emergency_stop
             ? phrase("Troubles", "%1 The emergency stop was pressed in the meantime.")
                   .with(stopped())
             : phrase("Troubles", "%1 The device is not ready yet: %2.")
                   .with(stopped(), problem.empty() ? interruption_by(status).reason : problem));
  }
  forget_surface();
  course_.event("fault_cleared", "");
  course_.update([](SessionSnapshot& snapshot) { snapshot.trouble.reset(); });
  course_.enter(before);
  course_.show({.kind = before == SessionPhase::paused ? ParticipantScene::Kind::paused
                                                       : ParticipantScene::Kind::blank});
  return true;
}

void Conductor::publish_trouble(const Phrase& what, SessionTrouble::Remedy remedy) {
  course_.update([&](SessionSnapshot& snapshot) {
    snapshot.trouble = SessionTrouble{what, course_.now_ns(), remedy};
  });
}

}  // namespace asperity
