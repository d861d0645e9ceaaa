#include "app/conductor/conductor.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/conductor/attempt_measures.h"
#include "app/conductor/recording_columns.h"
#include "app/parameter_json.h"
#include "renderers/offline/recorded_force.h"

namespace asperity {

namespace {

// A virtual hand explores a little longer than the protocol asks for at least, as people do.
constexpr double kBeyondMinimum = 1.25;
constexpr double kSlice_s = 0.02;
// From the wish to lift to the end of the contact.
constexpr double kLifting_s = 0.3;
constexpr double kCheck_s = 0.2;  // longer than a surface takes to fade out
// A surface that is not touched at all is given up after this much more than the longest contact.
constexpr double kPatience_s = 5.0;
// A device or machine that fails a trial three times will not do better the fourth time.
constexpr int kTechnicalRepeats = 3;

std::string options_json(const TrialQuestion& question) {
  nlohmann::ordered_json options = nlohmann::ordered_json::array();
  for (const Option& option : question.options) options.push_back(option.value);
  return options.dump();
}

double seconds_between(std::int64_t from_ns, std::int64_t to_ns) {
  return static_cast<double>(to_ns - from_ns) * 1e-9;
}

bool is_right(const AttemptRow& attempt) {
  return !attempt.responses.empty() &&
         std::all_of(attempt.responses.begin(), attempt.responses.end(),
                     [](const ResponseRow& response) { return response.correct.value_or(false); });
}

/// The attempt failed for a reason that the participant's way of exploring has no part in: the
/// machine was too slow, or a surface could not be touched at all.
bool failed_technically(const AttemptRow& attempt) {
  if (attempt.valid) return false;
  return attempt.outcome == AttemptOutcome::answered ||
         attempt.outcome == AttemptOutcome::timed_out ||
         std::any_of(attempt.presentations.begin(), attempt.presentations.end(),
                     [](const PresentationRow& surface) { return surface.contact_s <= 0.0; });
}

}  // namespace

struct Conductor::Surfaces {
  std::vector<PreparedStimulus> stimuli{};
  std::vector<Presentation> presentations{};  ///< renderer null while the loop has it
  std::vector<std::uint64_t> seeds{};
};

Conductor::Conductor(Study& study, const Protocol& protocol, StimulusBuilder& builder, Rig& rig,
                     Respondent& respondent, ConductorSettings settings)
    : study_(study),
      protocol_(protocol),
      builder_(builder),
      rig_(rig),
      respondent_(respondent),
      settings_(std::move(settings)) {}

SessionEnd Conductor::run(OpenSession session) {
  session_ = std::move(session);
  stopped_.reset();
  attempts_made_ = 0;
  const std::int64_t began_ns = rig_.clock().now_ns();
  if (session_.resumed) study_.reopen_session(session_.row.id);
  segment_ = study_.begin_segment(session_.row.id, began_ns);
  auto conditions = nlohmann::ordered_json::parse(settings_.conditions_json);
  if (conditions.is_object()) conditions["segment"] = segment_;
  study_.add_event(
      session_.row.id,
      {began_ns, session_.resumed ? "session_resumed" : "session_began", "", conditions.dump()});

  SessionEnd end{};
  try {
    run_steps();
  } catch (const Interruption& interruption) {  // outside an attempt
    stop(interruption.outcome == AttemptOutcome::device_fault
             ? "the device failed between trials: " + interruption.reason +
                   "; every finished trial is stored, go on with --resume"
             : interruption.reason);
  } catch (const RespondentGone& gone) {
    stop(gone.what());
  } catch (const std::exception& error) {
    end_after(error);
    throw;
  }
  rig_.loop().withdraw();
  if (stopped_) end = *stopped_;
  store_notes();
  end.attempts = attempts_made_;
  end.duration_s = seconds_between(began_ns, rig_.clock().now_ns());
  event(end.state == SessionState::completed ? "session_completed" : "session_stopped", end.reason);
  study_.end_segment(session_.row.id, segment_, rig_.clock().now_ns(),
                     end.state == SessionState::completed ? "completed" : "stopped");
  study_.end_session(session_.row.id, end.state, rig_.clock().utc());
  return end;
}

/// The store, a file or a renderer failed: every finished trial is on disk. Says so in the session
/// as far as the store still takes it; if it does not, the session is found as crashed.
void Conductor::end_after(const std::exception& error) noexcept {
  recorder_.abandon();
  rig_.loop().withdraw();
  try {
    event("session_failed", error.what());
    study_.end_segment(session_.row.id, segment_, rig_.clock().now_ns(), "stopped");
    study_.end_session(session_.row.id, SessionState::stopped, rig_.clock().utc());
  } catch (const std::exception&) {
    // The first error is the one that the caller is told.
  }
}

// --- requests ------------------------------------------------------------------------------------

void Conductor::stop_after(After what) {
  const std::lock_guard lock(requests_mutex_);
  requests_.stop = what;
}

void Conductor::abort(const std::string& reason) {
  const std::lock_guard lock(requests_mutex_);
  requests_.abort = reason;
}

void Conductor::skip(const std::string& reason) {
  const std::lock_guard lock(requests_mutex_);
  requests_.skip = reason;
}

void Conductor::pause() {
  const std::lock_guard lock(requests_mutex_);
  requests_.paused = true;
}

void Conductor::resume() {
  const std::lock_guard lock(requests_mutex_);
  requests_.paused = false;
}

void Conductor::note(const std::string& text) {
  const std::lock_guard lock(requests_mutex_);
  requests_.notes.push_back(text);
}

// --- the plan, step by step ----------------------------------------------------------------------

void Conductor::run_steps() {
  const std::vector<PlanStep>& steps = session_.plan.steps;
  // A resumed session goes on behind the last trial that was tried; what was read, asked and rested
  // before is not repeated.
  std::size_t first = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const TrialStep* step = std::get_if<TrialStep>(&steps[i]);
    if (step != nullptr && attempts_of(session_.plan.trials[step->trial].ordinal) > 0) first = i;
  }
  // The checks of the device are: it may be another one now, or the same one after a fault.
  for (std::size_t i = 0; i < first; ++i) {
    if (std::holds_alternative<Protocol::Check>(steps[i])) run_other(steps[i]);
  }
  int block = 0;
  for (std::size_t i = first; i < steps.size() && !stopped_; ++i) {
    if (is_asked_to_stop()) break;
    const TrialStep* step = std::get_if<TrialStep>(&steps[i]);
    if (step != nullptr) {
      const Trial& trial = session_.plan.trials[step->trial];
      if (trial.block_ordinal != block) {
        if (block != 0) finish_block(block);
        block = trial.block_ordinal;
      }
      if (stopped_ || is_done(trial) || is_over(trial)) continue;
      run_trial(trial);
      continue;
    }
    // What follows a block waits until the block is finished; what lies inside it (a break) happens
    // only while there is more of it to come.
    int next_block = 0;
    bool more_to_come = false;
    for (std::size_t later = i + 1; later < steps.size() && next_block == 0; ++later) {
      if (const TrialStep* next = std::get_if<TrialStep>(&steps[later])) {
        const Trial& trial = session_.plan.trials[next->trial];
        next_block = trial.block_ordinal;
        more_to_come = !is_over(trial);
      }
    }
    if (block != 0 && next_block == block) {
      if (more_to_come) run_other(steps[i]);
      continue;
    }
    if (block != 0) finish_block(block);
    block = 0;
    if (!stopped_) run_other(steps[i]);
  }
  if (block != 0 && !stopped_) finish_block(block);
}

/// A stop that was asked for while something was read or answered: there is no trial to wait for.
bool Conductor::is_asked_to_stop() {
  const std::lock_guard lock(requests_mutex_);
  if (requests_.stop != After::trial) return false;
  requests_.stop.reset();
  stop("as asked");
  return true;
}

void Conductor::run_other(const PlanStep& step) {
  const Wait waiting = [this](double duration_s) { wait(duration_s); };
  if (const auto* screen = std::get_if<Protocol::Screen>(&step)) {
    respondent_.read(screen->text, 0.0, waiting);
  } else if (const auto* pause = std::get_if<Protocol::Break>(&step)) {
    event("break_began", "");
    if (pause->zero_force) {
      check_device();
      event("force_zeroed", "break");
    }
    respondent_.read(pause->text, pause->minimum_s, waiting);
    event("break_ended", "");
  } else if (const auto* check = std::get_if<Protocol::Check>(&step)) {
    check_device();
    event("check_passed", check->what == Protocol::Check::What::device ? "device" : "force_zero");
  } else if (const auto* ask = std::get_if<Protocol::Ask>(&step)) {
    const std::vector<ResponseRow> answered = study_.session_answers(session_.row.id);
    for (const std::string& name : ask->questions) {
      const bool is_answered =
          std::any_of(answered.begin(), answered.end(),
                      [&name](const ResponseRow& row) { return row.question == name; });
      if (is_answered) continue;  // before the session was interrupted
      const Question& question = protocol_.questions.at(name);
      const std::int64_t cue_ns = rig_.clock().now_ns();
      const std::string answer = respondent_.answer(question, waiting);
      if (answer.empty() && question.optional) continue;
      ResponseRow row{};
      row.question = name;
      row.answer = answer;
      row.time_ns = rig_.clock().now_ns();
      row.from_cue_s = seconds_between(cue_ns, row.time_ns);
      row.source = respondent_.source();
      study_.add_session_answer(session_.row.id, row);
    }
  }
}

/// Nothing is rendered: the device has to answer at the servo's rate and be sent zero force.
void Conductor::check_device() {
  rig_.loop().withdraw();
  recorder_.begin(nullptr, protocol_.rate_Hz, rig_.records());
  wait(kCheck_s);
  const std::vector<TickRecord> records = recorder_.finish(rig_.records()).records;
  std::string problem{};
  if (records.empty()) {
    problem = "it does not tick";
  } else if (records.back().has(TickFlag::device_lost)) {
    problem = "it does not answer";
  } else if (records.back().sent.force_N != glm::dvec3{0.0}) {
    problem = "it is sent a force although there is no surface";
  }
  if (!problem.empty()) {
    throw Interruption{AttemptOutcome::device_fault, "the device is not ready: " + problem};
  }
}

void Conductor::finish_block(int block_ordinal) {
  // Rounds over what is still open: a trial that is asked again comes after all others.
  for (bool again = true; again && !stopped_;) {
    again = false;
    for (const Trial& trial : session_.plan.trials) {
      if (trial.block_ordinal != block_ordinal || stopped_ || is_done(trial) || is_over(trial)) {
        continue;
      }
      run_trial(trial);
      again = true;
    }
  }
  if (stopped_) return;
  const auto of_block = std::find_if(
      session_.plan.trials.begin(), session_.plan.trials.end(),
      [block_ordinal](const Trial& trial) { return trial.block_ordinal == block_ordinal; });
  const Protocol::Block& block = protocol_.blocks.at(of_block->block);
  if (block.until && criterion_of(*of_block) != BlockState::criterion_met) {
    event("criterion_not_met", of_block->block);
    if (block.until->on_failure == Protocol::Criterion::OnFailure::end_session) {
      stopped_ =
          SessionEnd{.state = SessionState::stopped,
                     .reason = "the criterion of the block \"" + of_block->block + "\" was not met",
                     .as_the_protocol_says = true};
    }
  }
  const std::lock_guard lock(requests_mutex_);
  if (requests_.stop == After::block && !stopped_) {
    requests_.stop.reset();
    stop("as asked, after the block");
  }
}

bool Conductor::is_done(const Trial& trial) const {
  return std::any_of(session_.attempts.begin(), session_.attempts.end(),
                     [&trial](const AttemptRow& attempt) {
                       return attempt.trial == trial.ordinal &&
                              (attempt.valid || attempt.outcome == AttemptOutcome::skipped);
                     });
}

bool Conductor::is_over(const Trial& trial) const {
  return criterion_of(trial) != BlockState::go_on;
}

BlockState Conductor::criterion_of(const Trial& trial) const {
  const Protocol::Block& block = protocol_.blocks.at(trial.block);
  if (!block.until) return BlockState::go_on;
  std::vector<bool> correct{};
  for (const AttemptRow& attempt : session_.attempts) {
    if (!attempt.valid) continue;
    const Trial& tried = session_.plan.trials.at(static_cast<std::size_t>(attempt.trial - 1));
    if (tried.block_ordinal != trial.block_ordinal) continue;
    correct.push_back(is_right(attempt));
  }
  return state_of(*block.until, correct);
}

int Conductor::explored_wrongly(int trial) const {
  return static_cast<int>(std::count_if(
      session_.attempts.begin(), session_.attempts.end(), [trial](const AttemptRow& attempt) {
        return attempt.trial == trial && attempt.outcome == AttemptOutcome::not_compliant &&
               !failed_technically(attempt);
      }));
}

int Conductor::attempts_of(int trial) const {
  return static_cast<int>(
      std::count_if(session_.attempts.begin(), session_.attempts.end(),
                    [trial](const AttemptRow& attempt) { return attempt.trial == trial; }));
}

const Exploration& Conductor::exploration_of(const Trial& trial) const {
  static const Exploration kFree{};
  const std::string& name = protocol_.blocks.at(trial.block).exploration;
  return name.empty() ? kFree : protocol_.explorations.at(name);
}

void Conductor::stop(const std::string& reason) {
  stopped_ = SessionEnd{.state = SessionState::stopped, .reason = reason};
}

// --- one trial -----------------------------------------------------------------------------------

void Conductor::run_trial(const Trial& trial) {
  const Exploration& exploration = exploration_of(trial);
  int failures = 0;
  for (;;) {
    between_trials();
    if (stopped_) return;
    AttemptRow attempt = run_attempt(trial, attempts_of(trial.ordinal) + 1);
    if (attempt.valid && attempt.outcome == AttemptOutcome::answered &&
        protocol_.blocks.at(trial.block).feedback != Protocol::Block::Feedback::none) {
      const bool right = is_right(attempt);
      std::string text = right ? "That was right." : "That was not right.";
      if (!right &&
          protocol_.blocks.at(trial.block).feedback == Protocol::Block::Feedback::correct_answer) {
        text += " The right answer:";
        for (const std::string& correct : trial.question.correct) {
          for (std::size_t i = 0; i < trial.question.options.size(); ++i) {
            if (trial.question.options[i].value == correct) {
              text += ' ' + trial.question.options[i].label;
            }
          }
        }
      }
      respondent_.tell(text, [this](double duration_s) { wait(duration_s); });
    }
    if (attempt.outcome == AttemptOutcome::device_fault) {
      const bool by_hand = rig_.loop().status().fault == Fault::emergency_stop;
      stop((by_hand ? "the emergency stop was pressed in trial " : "the device failed in trial ") +
           std::to_string(trial.ordinal) +
           (by_hand ? "" : ": " + attempt.invalid_reason.value_or("fault")));
      return;
    }
    if (attempt.outcome == AttemptOutcome::aborted) {
      stop(attempt.invalid_reason.value_or("aborted"));
      return;
    }
    if (attempt.valid || attempt.outcome == AttemptOutcome::skipped) break;
    if (failed_technically(attempt)) {
      if (++failures < kTechnicalRepeats) continue;
      stop("trial " + std::to_string(trial.ordinal) + " failed " + std::to_string(failures) +
           " times in a row (" + attempt.invalid_reason.value_or("") + ")");
      return;
    }
    if (attempt.outcome == AttemptOutcome::not_compliant &&
        exploration.on_failure == Exploration::OnFailure::requeue_at_end_of_block) {
      break;  // finish_block asks again
    }
  }
  const std::lock_guard lock(requests_mutex_);
  if (requests_.stop == After::trial) {
    requests_.stop.reset();
    stop("as asked, after the trial");
  }
}

void Conductor::between_trials() {
  store_notes();
  bool paused = false;
  for (;;) {
    {
      const std::lock_guard lock(requests_mutex_);
      if (requests_.abort) {
        stop(*requests_.abort);
        requests_.abort.reset();
        return;
      }
      if (!requests_.paused) break;
    }
    if (!paused) event("paused", "");
    paused = true;
    rig_.pass(kSlice_s, recorder_);
  }
  if (paused) event("resumed", "");
}

AttemptRow Conductor::run_attempt(const Trial& trial, int attempt) {
  const Protocol::Block& block = protocol_.blocks.at(trial.block);
  const Exploration& exploration = exploration_of(trial);
  const Random random = Random(std::stoull(session_.row.seed))
                            .split("attempt")
                            .split(static_cast<std::uint64_t>(trial.ordinal))
                            .split(static_cast<std::uint64_t>(attempt));
  AttemptRow row{};
  row.trial = trial.ordinal;
  row.attempt = attempt;
  row.segment = segment_;

  Surfaces surfaces{};
  nlohmann::ordered_json models = nlohmann::ordered_json::array();
  for (const PlannedPresentation& surface : trial.presentations) {
    const auto position = static_cast<std::uint64_t>(surface.position);
    PreparedStimulus prepared = builder_.prepare(surface, study_);
    prepared.inputs.seed = random.split("renderer").split(position).bits();
    models.push_back({{"position", surface.position},
                      {"model", prepared.model->declaration.id},
                      {"version", prepared.model->declaration.version}});
    surfaces.seeds.push_back(prepared.inputs.seed);
    surfaces.presentations.push_back({position, prepared.model->make(prepared.inputs)});
    surfaces.stimuli.push_back(std::move(prepared));
  }

  rig_.prepare_attempt(habits_for(exploration, protocol_.patch), random.split("hand"));
  respondent_.begin_attempt(trial.ordinal, attempt);
  std::unique_ptr<RecordingWriter> writer{};
  if (settings_.record && protocol_.record) {
    const nlohmann::ordered_json context{{"participant", session_.row.participant},
                                         {"session", session_.row.session},
                                         {"trial", trial.ordinal},
                                         {"attempt", attempt},
                                         {"presentations", models}};
    writer = std::make_unique<RecordingWriter>(
        study_.folder(), recording_path(trial, attempt),
        RecordingHeader{protocol_.rate_Hz, recording_columns(), context.dump()});
  }
  recorder_.begin(std::move(writer), protocol_.rate_Hz, rig_.records());
  row.onset_ns = rig_.clock().now_ns();

  const Wait waiting = [this](double duration_s) { wait(duration_s); };
  {
    const std::lock_guard lock(requests_mutex_);
    requests_.skip.reset();  // one that came between trials has nothing to skip
  }
  in_attempt_ = true;
  std::optional<Interruption> interruption{};
  Reply reply{};
  std::int64_t cue_ns = 0;
  std::int64_t answer_ns = 0;
  try {
    if (!trial.question.experimenter_prompt.empty()) {
      respondent_.read(trial.question.experimenter_prompt, 0.0, waiting);
    }
    wait(block.pause_before_trial_s);
    for (std::size_t i = 0; i < trial.presentations.size(); ++i) {
      if (i > 0) wait(block.pause_between_surfaces_s);
      respondent_.announce(trial, trial.presentations[i]);
      feel(i, surfaces, exploration);
    }
    for (;;) {
      std::vector<ForceFeatures> felt{};
      for (const PlannedPresentation& surface : trial.presentations) {
        felt.push_back(recorded_force_features({recorder_.records(),
                                                static_cast<std::uint64_t>(surface.position),
                                                protocol_.rate_Hz}));
      }
      cue_ns = rig_.clock().now_ns();
      reply = respondent_.ask(trial, felt, block.response_deadline_s, waiting);
      answer_ns = rig_.clock().now_ns();
      if (!reply.feel_again) break;
      const auto again = static_cast<std::size_t>(*reply.feel_again - 1);
      respondent_.announce(trial, trial.presentations.at(again));
      feel(again, surfaces, exploration);
    }
  } catch (const Interruption& caught) {
    interruption = caught;
  } catch (const RespondentGone& gone) {
    interruption = Interruption{AttemptOutcome::aborted, gone.what()};
  }
  in_attempt_ = false;
  row.offset_ns = rig_.clock().now_ns();
  if (interruption) take_surface_away();

  const Recorder::Attempt recorded = recorder_.finish(rig_.records());
  row.recording = recorded.recording;
  row.servo = servo_quality_of(recorded.records, protocol_.rate_Hz, recorded.lost_records);
  row.servo->fault = name_of(rig_.loop().status().fault);
  measure(trial, surfaces, exploration, recorded.records, row);

  if (interruption) {
    row.outcome = interruption->outcome;
    row.valid = false;
    row.invalid_reason = interruption->reason;
  } else {
    // No answer before the deadline is an outcome of the trial, and stays without a response.
    if (reply.options.empty()) row.outcome = AttemptOutcome::timed_out;
    for (std::size_t item = 0; item < reply.options.size(); ++item) {
      ResponseRow response{};
      response.question = trial.question.name;
      response.item = static_cast<int>(item) + 1;
      response.answer = trial.question.options.at(reply.options[item]).value;
      if (item < trial.question.correct.size()) {
        response.correct = response.answer == trial.question.correct[item];
      }
      response.options_json = options_json(trial.question);
      response.time_ns = answer_ns;
      response.from_cue_s = seconds_between(cue_ns, answer_ns);
      if (const auto contact_ns = row.presentations.front().contact_ns) {
        response.from_contact_s = seconds_between(*contact_ns, answer_ns);
      }
      response.source = respondent_.source();
      row.responses.push_back(std::move(response));
    }
    judge(exploration, row);
  }
  row.id = study_.add_attempt(session_.row.id, row);
  session_.attempts.push_back(row);
  ++attempts_made_;
  if (settings_.done) {
    settings_.done({session_.row.participant, session_.row.session, trial.ordinal, attempt});
  }
  return row;
}

void Conductor::feel(std::size_t index, Surfaces& surfaces, const Exploration& exploration) {
  Presentation& presentation = surfaces.presentations[index];
  const std::uint64_t id = presentation.id;
  recorder_.watch(id);
  rig_.loop().present(std::move(presentation));
  rig_.hand().stroke();
  const HandHabits habits = habits_for(exploration, protocol_.patch);
  const double strokes_s = exploration.strokes.target.value_or(0.0) * kBeyondMinimum *
                           habits.stroke_length_m / habits.speed_m_per_s;
  const double longest_s =
      std::max(exploration.minimum_contact_s, exploration.maximum_contact_s - kLifting_s);
  const double wanted_s =
      std::min(std::max(kBeyondMinimum * exploration.minimum_contact_s, strokes_s), longest_s);
  double passed_s = 0.0;
  while (recorder_.live().contact_s < wanted_s &&
         passed_s < exploration.maximum_contact_s + kPatience_s) {
    wait(kSlice_s);
    passed_s += kSlice_s;
  }
  rig_.hand().lift();
  for (passed_s = 0.0; recorder_.live().touching && passed_s < kPatience_s; passed_s += kSlice_s) {
    wait(kSlice_s);
  }
  rig_.loop().withdraw();
  while (presentation.renderer == nullptr) {
    wait(kSlice_s);
    presentation = rig_.loop().collect();
  }
  if (recorder_.live().contact_s <= 0.0) {
    throw Interruption{AttemptOutcome::not_compliant,
                       "surface " + std::to_string(id) + " was not touched"};
  }
}

void Conductor::measure(const Trial& trial, const Surfaces& surfaces,
                        const Exploration& exploration, const std::vector<TickRecord>& records,
                        AttemptRow& row) const {
  for (std::size_t i = 0; i < trial.presentations.size(); ++i) {
    const PlannedPresentation& planned = trial.presentations[i];
    const PreparedStimulus& prepared = surfaces.stimuli[i];
    const auto id = static_cast<std::uint64_t>(planned.position);
    PresentationRow presentation{};
    presentation.position = planned.position;
    presentation.role = planned.role;
    presentation.item = planned.item;
    presentation.stimulus = planned.stimulus.name;
    presentation.model = prepared.model->declaration.id;
    presentation.model_version = prepared.model->declaration.version;
    presentation.texture = planned.stimulus.texture;
    presentation.parameters_json = json_text_of(prepared.inputs.parameters);
    presentation.height_field_sha256 = prepared.height_field_sha256;
    presentation.seed = std::to_string(surfaces.seeds[i]);
    presentation.matched_texture_force_N = prepared.matched_texture_force_N;
    fill_times(records, id, protocol_.rate_Hz, presentation);
    const EqualForce request = planned.equal_force.value_or(EqualForce{});
    presentation.achieved_texture_force_N = recorded_texture_force_rms_N(
        *prepared.model, prepared.inputs, {records, id, protocol_.rate_Hz},
        {request.band_low_Hz, request.band_high_Hz});
    if (presentation.onset_ns) {
      for (ComplianceRow& compliance : compliance_of(records, id, protocol_.rate_Hz, exploration)) {
        compliance.position = planned.position;
        row.compliance.push_back(std::move(compliance));
      }
    }
    row.presentations.push_back(std::move(presentation));
  }
}

void Conductor::judge(const Exploration& exploration, AttemptRow& row) const {
  const ServoQualityRow& servo = *row.servo;
  if (servo.missed_deadlines > protocol_.maximum_missed_deadlines) {
    row.valid = false;
    row.invalid_reason = std::to_string(servo.missed_deadlines) + " missed deadlines, at most " +
                         std::to_string(protocol_.maximum_missed_deadlines) + " allowed";
    return;
  }
  if (servo.lost_records > protocol_.maximum_lost_records) {
    row.valid = false;
    row.invalid_reason = std::to_string(servo.lost_records) + " lost records, at most " +
                         std::to_string(protocol_.maximum_lost_records) + " allowed";
    return;
  }
  std::string flags{};
  const auto flag = [&flags](const std::string& text) {
    if (!flags.empty()) flags += "; ";
    flags += text;
  };
  if (servo.saturated_ticks > 0) {
    flag("force limited in " + std::to_string(servo.saturated_ticks) + " ticks");
  }
  std::string failures{};
  for (const ComplianceRow& compliance : row.compliance) {
    if (compliance.passed.value_or(true)) continue;
    if (!failures.empty()) failures += ", ";
    failures += compliance.quantity + " of surface " + std::to_string(compliance.position);
  }
  if (!failures.empty()) {
    const bool ask_again = exploration.on_failure != Exploration::OnFailure::flag &&
                           explored_wrongly(row.trial) < exploration.maximum_repeats;
    if (ask_again) {
      row.outcome = AttemptOutcome::not_compliant;
      row.valid = false;
      row.invalid_reason = "not explored as asked: " + failures;
      return;
    }
    flag("not explored as asked: " + failures);
  }
  if (!flags.empty()) {
    row.flagged = true;
    row.flag_reason = flags;
  }
}

void Conductor::take_surface_away() {
  rig_.hand().lift();
  rig_.loop().withdraw();
  for (double passed_s = 0.0; passed_s < 1.0 && rig_.loop().status().fault == Fault::none;
       passed_s += kSlice_s) {
    rig_.pass(kSlice_s, recorder_);
    if (rig_.loop().collect().renderer != nullptr) break;
  }
}

// --- time and events -----------------------------------------------------------------------------

void Conductor::wait(double duration_s) {
  double left_s = duration_s;
  do {
    const double slice_s = std::min(left_s, kSlice_s);
    rig_.pass(slice_s, recorder_);
    left_s -= slice_s;
    const ServoStatus status = rig_.loop().status();
    if (status.fault != Fault::none) {
      throw Interruption{AttemptOutcome::device_fault, name_of(status.fault)};
    }
    const std::lock_guard lock(requests_mutex_);
    if (requests_.abort) {
      const std::string reason = *requests_.abort;
      requests_.abort.reset();
      throw Interruption{AttemptOutcome::aborted, reason};
    }
    if (requests_.skip && in_attempt_) {
      const std::string reason = *requests_.skip;
      requests_.skip.reset();
      throw Interruption{AttemptOutcome::skipped, reason};
    }
  } while (left_s > 1e-9);
}

void Conductor::store_notes() {
  std::vector<std::string> notes{};
  {
    const std::lock_guard lock(requests_mutex_);
    notes.swap(requests_.notes);
  }
  for (const std::string& text : notes) event("note", text);
}

void Conductor::event(const std::string& kind, const std::string& text) {
  study_.add_event(session_.row.id, {rig_.clock().now_ns(), kind, text, "null"});
}

std::string Conductor::recording_path(const Trial& trial, int attempt) const {
  const auto padded = [](int number, std::size_t width) {
    std::string digits = std::to_string(number);
    if (digits.size() < width) digits.insert(0, width - digits.size(), '0');
    return digits;
  };
  return "recordings/" + session_.row.participant + "/session-" + padded(session_.row.session, 2) +
         "/trial-" + padded(trial.ordinal, 4) + "_attempt-" + std::to_string(attempt) + ".rec";
}

}  // namespace asperity
