// Implements a loop over the steps of the plan, in which a step is repeated after a fault.

#include "app/session/conductor.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/session/anchor_summary.h"
#include "app/session/levels/level_program.h"
#include "app/session/rig/clock.h"
#include "app/session/trial_attempt.h"
#include "app/session/trial_outcome.h"
#include "app/words/coded_phrases.h"
#include "app/words/reason.h"
#include "protocols/plan/course.h"
#include "protocols/plan/groups.h"
#include "protocols/texts/protocol_texts.h"

namespace asperity {

namespace {

// A device or machine that fails a trial three times is unlikely to succeed the fourth time.
constexpr int kTechnicalRepeats = 3;
// Shorter waits for a stimulus are not stored: they are not noticed between two trials.
constexpr double kNoticeableWait_s = 0.1;
// Stored for a participant's session that cannot play sound (at a terminal), in the format of
// Sound::description_json.
constexpr const char* kNoNoise = R"({"kind":"none","heard":false})";

}  // namespace

Conductor::Conductor(Study& study, const Protocol& protocol, StimulusBuilder& builder, Rig& rig,
                     Respondent& respondent, ConductorSettings settings)
    : study_(study),
      protocol_(protocol),
      rig_(rig),
      respondent_(respondent),
      settings_(std::move(settings)),
      requests_(settings_.links.requests == nullptr ? own_requests_ : *settings_.links.requests),
      course_(study, protocol, rig, respondent, requests_, settings_.links),
      upcoming_(builder, study),
      outside_([this](double duration_s) { course_.wait_outside_trial(duration_s); }),
      unheeding_([this](double duration_s) {
        for (double passed_s = 0.0; passed_s < duration_s; passed_s += SessionCourse::kSlice_s) {
          course_.pass_slice();
        }
      }) {
  course_.set_each_slice([this] {
    if (level_program_) level_program_->attend(0.0);
  });
}

Conductor::~Conductor() = default;

SessionEnd Conductor::run(OpenSession session) {
  session_ = std::move(session);
  stopped_.reset();
  attempts_made_ = 0;
  standstills_ = 0;
  contact_since_break_s_ = 0.0;
  is_refreshing_ = false;
  const std::int64_t began_ns = rig_.clock().now_ns();
  requests_.attach(rig_);
  const struct Attached {
    SessionRequests& requests;
    ~Attached() { requests.detach(); }
  } attached{requests_};
  try {
    begin();
    if (!stopped_) run_steps();
  } catch (const Interruption& interruption) {  // outside an attempt
    stop(is_fault(interruption.outcome) ? with_semicolon(fault_sentence(interruption, {}),
                                                         phrase_of(Reason::every_trial_stored))
                                        : interruption.reason);
  } catch (const RespondentGone& gone) {
    stop(gone.said());
  } catch (const std::exception& error) {
    end_after(error);
    throw;
  }
  return finish(began_ns);
}

void Conductor::begin() {
  const std::int64_t began_ns = rig_.clock().now_ns();
  course_.begin(session_.row);
  upcoming_.begin(session_.row);
  progress_.reset();
  SessionFacts facts = facts_of_session();
  tally_.emplace(protocol_, plan());
  for (AttemptRow& attempt : std::exchange(session_.attempts, {})) tally_->add(std::move(attempt));
  if (session_.resumed) {
    study_.reopen_session(session_.row.id);
    // Only a plan that depends on responses can have trials that are not stored yet.
    if (session_.row.expected_trials) store_trials(study_.plan(session_.row.id).size());
    for (const auto& [trial, attempt] : set_aside_in(study_.decisions(session_.row.id))) {
      tally_->remember_set_aside(trial, attempt);
    }
  }
  // Before the first step that may fail: a session that is in the store can be resumed.
  course_.set_facts(std::move(facts));
  segment_ = study_.begin_segment(session_.row.id, began_ns);
  auto conditions = nlohmann::ordered_json::parse(settings_.conditions_json);
  if (conditions.is_object()) conditions["segment"] = segment_;
  course_.event(session_.resumed ? "session_resumed" : "session_began", "", conditions.dump());
  progress_.emplace(course_, *session_.course, *tally_, began_ns);
  // May wait for the sound card to open; the windows are informed before.
  if (settings_.links.sound != nullptr) {
    course_.event("masking_noise", "", settings_.links.sound->description_json());
  } else if (session_.row.mode != SessionMode::simulate) {
    course_.event("masking_noise", "", kNoNoise);
  }
  note_guidance();
  note_texts();
  note_earlier_matches();
  course_.enter(SessionPhase::ready);
  supply_levels();
}

SessionFacts Conductor::facts_of_session() const {
  SessionFacts facts{.protocol = std::make_shared<const Protocol>(protocol_),
                     .plan = std::make_shared<const Plan>(course_.shown_of(plan())),
                     .row = session_.row,
                     .study_folder = study_.folder().string(),
                     .mirrored = session_.row.mirrored,
                     .clock_ahead_ns = rig_.clock().ahead_ns()};
  if (!session_.resumed) return facts;
  facts.earlier_s = study_.session_counts(session_.row.id).running_s;
  for (EventRow& event : events_in_order(study_.events(session_.row.id), session_.attempts)) {
    if (event.kind == "note") facts.earlier_notes.push_back(phrase_of(event));
  }
  return facts;
}

/// Stores whether the participant sees and hears the guidance that the protocol requests; a virtual
/// participant and a participant at a terminal have neither.
void Conductor::note_guidance() {
  if (!guides_participants(protocol_)) return;
  const bool sees = respondent_.wears_mask();  // has a window to look at
  const bool hears = settings_.links.sound != nullptr && settings_.links.sound->is_heard();
  const bool is_told = std::all_of(
      protocol_.explorations.begin(), protocol_.explorations.end(), [&](const auto& each) {
        using Guidance = Exploration::Guidance;
        const Guidance guidance = each.second.guidance;
        return guidance == Guidance::experimenter || (guidance == Guidance::tones ? hears : sees);
      });
  course_.event("guidance", is_told ? "given" : "not_given");
}

void Conductor::note_texts() {
  std::vector<TextPlace> places = texts_with_placeholders(protocol_);
  std::erase_if(places, [group = allocation_of(session_.row).group](const TextPlace& each) {
    return !is_for_group(each.groups, group);
  });
  values_ = states_session(places)
                ? values_of_session(protocol_, example_plan(protocol_, allocation_of(session_.row)))
                : values_of_all_blocks(protocol_);
  for (const TextAsRead& each : texts_as_read(protocol_, places, values_)) {
    course_.event("text_as_read", each.text,
                  nlohmann::ordered_json{{"place", each.pointer}}.dump());
  }
}

std::string Conductor::as_read(const std::string& text) const {
  return with_values(text, values_, protocol_.language);
}

SessionEnd Conductor::finish(std::int64_t began_ns) {
  rig_.loop().withdraw();
  upcoming_.make_ahead({});
  SessionEnd end{};
  if (stopped_) end = *stopped_;
  course_.set_masking(false);
  course_.set_guiding_tones(false);
  course_.store_respondent_events();
  course_.store_remarks();
  end.attempts = attempts_made_;
  end.anchors = anchor_summary(plan(), tally_->attempts());
  end.duration_s = seconds_between(began_ns, rig_.clock().now_ns());
  course_.event(end.state == SessionState::completed ? "session_completed" : "session_stopped",
                end.reason);
  if (course_.has_monitor()) course_.event("phase", text_of(SessionPhase::ended));
  study_.end_segment(session_.row.id, segment_, rig_.clock().now_ns(),
                     end.state == SessionState::completed ? "completed" : "stopped");
  study_.end_session(session_.row.id, end.state, rig_.clock().utc());
  if (end.state != SessionState::completed && !end.as_the_protocol_says) {
    publish_trouble(
        phrase("Troubles", "%1 Every completed trial is stored.").with(end.reason.as_sentence()),
        SessionTrouble::Remedy::try_again);
  }
  course_.play(Cue::finished);
  course_.show({.kind = ParticipantScene::Kind::ended});
  course_.publish(SessionPhase::ended);
  end_program();  // last: the end of the session is stored, whatever the program does
  return end;
}

/// Handles a failure of the store, a file or a renderer: every completed trial is on disk. Stores
/// the reason in the session if the store still accepts it; otherwise the session is later found as
/// crashed.
void Conductor::end_after(const std::exception& error) noexcept {
  course_.recorder().abandon();
  rig_.hand().lift();
  rig_.loop().withdraw();
  try {
    level_program_.reset();
    course_.set_masking(false);
    course_.set_guiding_tones(false);
    publish_trouble(phrase("Troubles", "%1; the force is zero, and every completed trial is stored")
                        .with(phrase_of(error))
                        .as_sentence(),
                    SessionTrouble::Remedy::try_again);
    course_.show({.kind = ParticipantScene::Kind::ended});
    course_.publish(SessionPhase::ended);
    course_.take_attempt_events();  // of an attempt that has no row
    course_.store_remarks();
    course_.event("session_failed", Phrase("%1").with(phrase_of(error)));
    study_.end_segment(session_.row.id, segment_, rig_.clock().now_ns(), "stopped");
    study_.end_session(session_.row.id, SessionState::stopped, rig_.clock().utc());
  } catch (const std::exception&) {
    // The first error is the one reported to the caller.
  }
}

void Conductor::stop(const Phrase& reason) {
  stopped_ = SessionEnd{.state = SessionState::stopped, .reason = reason};
}

// --- the plan, step by step ----------------------------------------------------------------------

void Conductor::run_steps() {
  const std::vector<PlanStep>& steps = plan().steps;
  // A resumed session continues after the last trial that was attempted; earlier texts,
  // questionnaires and breaks are not repeated.
  std::size_t first = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const TrialStep* step = std::get_if<TrialStep>(&steps[i]);
    if (step != nullptr && tally_->attempts_at(plan().trials[step->trial].ordinal) > 0) first = i;
  }
  if (first > 0) lead_back(first);
  block_ = 0;
  resume_repeats(first);
  for (std::size_t i = first; i < steps.size() && !stopped_; ++i) {
    step_ = i;
    // A stop requested during a text or a questionnaire: there is no trial to wait for.
    if (requests_.take_stop(StopAfter::trial)) {
      stop(phrase_of(Reason::as_asked));
      break;
    }
    // Requested between two blocks: the block it refers to is over.
    if (block_ == 0 && !tally_->attempts().empty() && requests_.take_stop(StopAfter::block)) {
      stop(phrase_of(Reason::as_asked_after_block));
      break;
    }
    const TrialStep* step = std::get_if<TrialStep>(&steps[i]);
    if (step != nullptr) {
      const Trial& trial = plan().trials[step->trial];
      if (trial.block_ordinal != block_) {
        if (block_ != 0) finish_block(block_);
        block_ = trial.block_ordinal;
      }
      if (stopped_ || tally_->is_done(trial) || tally_->is_over(trial) || is_put_off(trial)) {
        continue;
      }
      rest_after_contact(trial);
      if (!stopped_) run_trial(trial);
      continue;
    }
    // What follows a block waits until the block is finished; a break within the block takes place
    // only while more of its trials remain.
    int next_block = 0;
    bool more_to_come = false;
    for (std::size_t later = i + 1; later < steps.size() && next_block == 0; ++later) {
      if (const TrialStep* next = std::get_if<TrialStep>(&steps[later])) {
        const Trial& trial = plan().trials[next->trial];
        next_block = trial.block_ordinal;
        more_to_come = !tally_->is_over(trial);
      }
    }
    if (block_ != 0 && next_block == block_) {
      if (more_to_come) run_other(steps[i]);
      continue;
    }
    if (block_ != 0) finish_block(block_);
    block_ = 0;
    course_.update([](SessionSnapshot& snapshot) { snapshot.block = 0; });
    if (!stopped_) run_other(steps[i]);
  }
  if (!stopped_) step_ = steps.size();
  if (block_ != 0 && !stopped_) finish_block(block_);
  block_ = 0;
  if (!stopped_) between_steps(Next::other);
  // The eye mask is off before the session ends.
  if (!stopped_) course_.put_mask(false, [this](double duration_s) { course_.wait(duration_s); });
}

/// Runs a step that is not a trial; it is started again after a fault.
void Conductor::run_other(const PlanStep& step) {
  run_outside_trials([&] { try_other(step); });
}

void Conductor::run_outside_trials(const std::function<void()>& step) {
  for (;;) {
    between_steps(Next::other);
    if (stopped_) return;
    try {
      step();
      course_.store_respondent_events();
      show_progress();
      return;
    } catch (const Interruption& interruption) {
      course_.store_respondent_events();
      if (!outlives(interruption)) throw;
      if (stopped_) return;
    }
  }
}

void Conductor::try_other(const PlanStep& planned) {
  const PlanStep step = asperity::as_read(planned, values_, protocol_.language);
  if (const auto* screen = std::get_if<Protocol::Screen>(&step)) {
    if (!holds(screen->condition)) return;
    let_read(scene_to_read(screen->text));
  } else if (const auto* pause = std::get_if<Protocol::Break>(&step)) {
    rest(*pause);
  } else if (const auto* check = std::get_if<Protocol::Check>(&step)) {
    course_.enter(SessionPhase::ready);
    check_device();
    course_.event("check_passed",
                  check->what == Protocol::Check::What::device ? "device" : "force_zero");
  } else if (const auto* questions = std::get_if<Protocol::Ask>(&step)) {
    ask(*questions);
  }
  course_.show({});
}

void Conductor::let_read(const ParticipantScene& scene) {
  course_.enter(SessionPhase::ready);
  course_.put_mask(false, outside_);
  course_.show(scene);
  respondent_.read(scene.text, 0.0, outside_);
  course_.show({});
}

void Conductor::rest(const Protocol::Break& pause) {
  course_.enter(SessionPhase::rest);
  course_.event("break_began", "");
  if (pause.zero_force) {
    check_device();
    course_.event("force_zeroed", "break");
  }
  course_.put_mask(false, outside_);
  if (pause.drift_check) check_drift(*pause.drift_check);
  ParticipantScene scene{.kind = ParticipantScene::Kind::rest, .text = pause.text};
  scene.rest_until_ns = course_.now_ns() + static_cast<std::int64_t>(pause.minimum_s * 1e9);
  course_.show(std::move(scene));
  course_.play(Cue::rest);
  respondent_.read(pause.text, pause.minimum_s, outside_);
  contact_since_break_s_ = 0.0;
  course_.play(Cue::rest);
  course_.event("break_ended", "");
}

/// A break between two trials of a block, once surfaces were in contact for long enough since the last one.
void Conductor::rest_after_contact(const Trial& next) {
  const std::vector<AttemptRow>& made = tally_->attempts();
  if (made.empty()) return;
  const Trial& last = plan().trials.at(static_cast<std::size_t>(made.back().trial - 1));
  if (last.block_ordinal != next.block_ordinal) return;
  const Protocol::Run& run = session_.course->run_of(next.block_ordinal);
  const double limit_s = run.break_every_contact_s;
  if (limit_s > 0.0 && contact_since_break_s_ >= limit_s) run_other(*run.pause);
}

void Conductor::finish_block(int block_ordinal) {
  // Rounds over the open trials: a trial that is asked again comes after all others.
  for (bool again = true; again && !stopped_;) {
    again = false;
    // The last trial is repeated before a requested stop after the block takes effect.
    repeat_as_asked();
    for (std::size_t i = 0; i < plan().trials.size(); ++i) {
      const Trial& trial = plan().trials[i];
      if (trial.block_ordinal != block_ordinal || stopped_ || tally_->is_done(trial) ||
          tally_->is_over(trial)) {
        continue;
      }
      rest_after_contact(trial);
      if (!stopped_) run_trial(trial);
      again = true;
    }
  }
  if (stopped_) return;
  const auto of_block = std::find_if(
      plan().trials.begin(), plan().trials.end(),
      [block_ordinal](const Trial& trial) { return trial.block_ordinal == block_ordinal; });
  const Protocol::Block& block = protocol_.blocks.at(of_block->block);
  if (block.until && tally_->criterion_of(*of_block) != BlockState::criterion_met) {
    course_.event("criterion_not_met", of_block->block);
    if (block.until->on_failure == Protocol::Criterion::OnFailure::end_session) {
      stopped_ = SessionEnd{.state = SessionState::stopped,
                            .reason = phrase_of(Reason::criterion_not_met).with(of_block->block),
                            .as_the_protocol_says = true};
    }
  }
  if (!stopped_ && requests_.take_stop(StopAfter::block)) {
    stop(phrase_of(Reason::as_asked_after_block));
  }
}

// --- one trial -----------------------------------------------------------------------------------

void Conductor::run_trial(const Trial& trial, AttemptPurpose purpose) {
  int failures = 0;
  for (;;) {
    do {
      course_.enter(SessionPhase::iti);
      course_.update([&](SessionSnapshot& snapshot) {
        snapshot.block = trial.block_ordinal;
        snapshot.trial = trial.ordinal;
        snapshot.attempt = tally_->attempts_at(trial.ordinal) + 1;
        snapshot.purpose = purpose;
      });
      course_.show({});
    } while (between_steps(Next::trial) && !stopped_);
    if (stopped_) return;
    std::optional<Interruption> interruption{};
    const AttemptRow attempt = make_attempt(trial, purpose, interruption);
    tell(trial, attempt);
    // After the feedback, which follows the response at once.
    if (!stopped_) supply_levels();
    if (stopped_) return;
    if (is_fault(attempt.outcome)) {
      if (!wait_out_fault(fault_sentence(interruption.value(), trial.ordinal))) return;
      continue;
    }
    if (interruption && interruption->ask_again) {
      pause_without_noise();  // also where it has returned meanwhile
      continue;
    }
    if (attempt.outcome == AttemptOutcome::aborted) {
      stop(attempt.invalid_reason ? phrase_of(attempt.invalid_reason) : phrase_of(Reason::aborted));
      return;
    }
    if (attempt.valid || attempt.outcome == AttemptOutcome::skipped) break;
    if (purpose == AttemptPurpose::refresher) break;  // how it went does not matter
    if (has_excessive_buzz(attempt)) continue;        // TrialAttempt limits these repeats
    if (failed_technically(attempt)) {
      if (++failures < kTechnicalRepeats) continue;
      stop(phrase_of(Reason::failed_repeatedly)
               .with(std::to_string(trial.ordinal), std::to_string(failures),
                     phrase_of(attempt.invalid_reason)));
      return;
    }
    if (waits_for_others(trial, attempt)) break;  // finish_block asks again
  }
  const bool is_last = settings_.links.last_trial && trial.ordinal >= *settings_.links.last_trial;
  if (requests_.take_stop(StopAfter::trial) || is_last) {
    stop(phrase_of(Reason::as_asked_after_trial));
  }
}

AttemptRow Conductor::make_attempt(const Trial& trial, AttemptPurpose purpose,
                                   std::optional<Interruption>& interruption) {
  const AttemptOrder order{.trial = trial,
                           .attempt = tally_->attempts_at(trial.ordinal) + 1,
                           .segment = segment_,
                           .purpose = purpose,
                           .explored_wrongly = tally_->explored_wrongly(trial.ordinal),
                           .earlier_estimate = tally_->earlier_estimate(trial),
                           .repeated_for_buzz = tally_->repeated_for_buzz(trial.ordinal),
                           .record = settings_.record};
  course_.update([&order](SessionSnapshot& snapshot) {
    snapshot.trial = order.trial.ordinal;
    snapshot.attempt = order.attempt;
    snapshot.purpose = order.purpose;
  });
  if (purpose == AttemptPurpose::trial) tell_of_repetition(trial);
  TrialAttempt attempt(course_, surfaces_of(trial, order.attempt), order);
  AttemptRow row = attempt.make();
  interruption = attempt.interruption();
  row.id = study_.add_attempt(session_.row.id, row);
  tally_->add(row);
  ++attempts_made_;
  for (const PresentationRow& surface : row.presentations) {
    contact_since_break_s_ += surface.contact_s;
  }
  extend_plan(trial, row);
  const TrialTally::Again again =
      waits_for_others(trial, row) ? TrialTally::Again::after_others : TrialTally::Again::at_once;
  progress_->add(row, step_, tally_->coming(step_, block_, trial.ordinal, again));
  if (settings_.done) {
    settings_.done({.participant = session_.row.participant,
                    .session = session_.row.session,
                    .trial = trial.ordinal,
                    .attempt = order.attempt,
                    .counts = row.valid && purpose == AttemptPurpose::trial,
                    .outcome = row.outcome});
  }
  return row;
}

/// Waits for the surfaces of the attempt; those of the attempts that can follow are made meanwhile.
TrialSurfaces Conductor::surfaces_of(const Trial& trial, int attempt) {
  const std::int64_t began_ns = course_.now_ns();
  TrialSurfaces surfaces = upcoming_.take(trial, attempt);
  const double waited_s = seconds_between(began_ns, course_.now_ns());
  if (waited_s >= kNoticeableWait_s) {
    const nlohmann::ordered_json data{
        {"trial", trial.ordinal}, {"attempt", attempt}, {"waited_s", waited_s}};
    course_.event("stimulus_wait", "", data.dump());
  }
  if (settings_.makes_ahead) make_ahead(trial, attempt);
  return surfaces;
}

void Conductor::make_ahead(const Trial& trial, int attempt) {
  try {
    std::vector<NextTrial> next = possible_after(trial);
    const Exploration& exploration = exploration_of(protocol_, trial);
    const bool repeats_for_buzz =
        protocol_.instability && protocol_.instability->on == InstabilityRule::OnExcess::repeat_now;
    if (repeats_for_buzz || (exploration.on_failure == Exploration::OnFailure::repeat_now &&
                             exploration.maximum_repeats > 0)) {
      next.push_back({.trial = trial, .attempt = attempt + 1});
    }
    upcoming_.make_ahead(std::move(next));
  } catch (const std::exception&) {
    // Surfaces that are not made ahead are made when they are needed.
  }
}

/// The attempts that can follow once this trial is done.
std::vector<NextTrial> Conductor::possible_after(const Trial& trial) const {
  const auto as_next = [this](const Trial& next) {
    return NextTrial{.trial = next, .attempt = tally_->attempts_at(next.ordinal) + 1};
  };
  std::vector<NextTrial> next{};
  const Trial* const awaited = session_.course->awaited();
  if (awaited != nullptr && awaited->ordinal == trial.ordinal) {
    for (const Trial& each : session_.course->possible_next()) next.push_back(as_next(each));
    return next;
  }
  const int coming = tally_->coming(step_, block_, trial.ordinal, TrialTally::Again::after_others);
  const auto following =
      std::find_if(plan().trials.begin(), plan().trials.end(), [&](const Trial& each) {
        // The last trial of a block comes again only if it is not done; otherwise the next block begins.
        return coming == trial.ordinal ? each.ordinal > trial.ordinal && !tally_->is_done(each)
                                       : each.ordinal == coming;
      });
  if (following != plan().trials.end()) next.push_back(as_next(*following));
  return next;
}

/// Stores the trials of the plan that the store lacks: those from index `first`.
void Conductor::store_trials(std::size_t first) {
  std::vector<PlannedTrialRow> rows{};
  for (std::size_t i = first; i < plan().trials.size(); ++i) {
    rows.push_back(planned_row(plan().trials[i]));
  }
  if (!rows.empty()) study_.add_trials(session_.row.id, rows);
}

/// Determines the trials that follow the awaited one, once it is completed, and stores them.
void Conductor::extend_plan(const Trial& trial, const AttemptRow& attempt) {
  const Trial* const awaited = session_.course->awaited();
  if (awaited == nullptr || awaited->ordinal != trial.ordinal || !tally_->is_done(trial)) return;
  const std::size_t before = plan().trials.size();
  tell_program(trial, attempt);
  session_.course->advance(outcome_of(protocol_, trial, attempt));
  store_trials(before);
  note_matches();
  progress_->extend();
  course_.set_plan(plan());
}

/// Reports why a trial is repeated to a user who has no window that shows it.
void Conductor::tell_of_repetition(const Trial& trial) const {
  if (!settings_.links.tell) return;
  const std::vector<AttemptRow>& made = tally_->attempts();
  const auto last = std::find_if(made.rbegin(), made.rend(), [&trial](const AttemptRow& attempt) {
    return attempt.trial == trial.ordinal;
  });
  if (last == made.rend()) return;
  settings_.links.tell(
      "Trial " + std::to_string(trial.ordinal) + " is repeated: " +
      (last->invalid_reason ? phrase_of(last->invalid_reason).english() : text_of(last->outcome)) +
      '.');
}

bool Conductor::waits_for_others(const Trial& trial, const AttemptRow& attempt) const {
  // An anchor is a reference at its place in the block, and is therefore repeated at once.
  return trial.repetition > 0 && attempt.outcome == AttemptOutcome::not_compliant &&
         !failed_technically(attempt) &&
         exploration_of(protocol_, trial).on_failure ==
             Exploration::OnFailure::requeue_at_end_of_block;
}

/// Whether the trial was postponed to the end of its block before the session was interrupted.
bool Conductor::is_put_off(const Trial& trial) const {
  const std::vector<AttemptRow>& made = tally_->attempts();
  const auto last = std::find_if(made.rbegin(), made.rend(), [&trial](const AttemptRow& attempt) {
    return attempt.trial == trial.ordinal;
  });
  return last != made.rend() && !last->valid && waits_for_others(trial, *last);
}

void Conductor::show_progress() {
  progress_->show(step_, tally_->coming(step_, block_, 0, TrialTally::Again::at_once));
}

/// Gives feedback, where the block has feedback.
void Conductor::tell(const Trial& trial, const AttemptRow& attempt) {
  using Feedback = Protocol::Block::Feedback;
  const Feedback feedback = protocol_.blocks.at(trial.block).feedback;
  if (!attempt.valid || attempt.outcome != AttemptOutcome::answered || feedback == Feedback::none) {
    return;
  }
  const bool right = is_right(attempt);
  std::string right_answer{};
  if (feedback == Feedback::correct_answer) {
    for (const Question& question : trial.questions) {
      for (const std::string& correct : question.correct) {
        for (const Option& option : question.options) {
          if (option.value != correct) continue;
          if (!right_answer.empty()) right_answer += ' ';
          right_answer += option.label;
        }
      }
    }
  }
  ParticipantScene scene = scene_of_feedback(right, right_answer);
  const std::string text = scene.text;
  course_.enter(SessionPhase::feedback);
  course_.show(std::move(scene));
  course_.play(right ? Cue::right : Cue::wrong);
  try {
    respondent_.tell(text, [this](double duration_s) { course_.wait(duration_s); });
  } catch (const Interruption& interruption) {
    if (!outlives(interruption)) throw;
  }
}

}  // namespace asperity
