// Waits in slices, in each of which the recorder, the device, requests and the monitor are attended to.

#include "app/session/session_course.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "app/words/coded_phrases.h"
#include "app/words/reason.h"

namespace asperity {

namespace {

constexpr double kUnexplained_s = 0.5;  // a shorter silence needs no explanation
// The rate at which displayed numbers are refreshed, slow enough to be read.
constexpr std::int64_t kHealthEvery_ns = 250'000'000;

}  // namespace

Interruption interruption_by(const ServoStatus& status) {
  if (status.fault == Fault::emergency_stop) {
    return {.outcome = AttemptOutcome::emergency_stop,
            .reason = phrase_of(Reason::emergency_stop),
            .fault = status.fault};
  }
  return {.outcome = AttemptOutcome::device_fault,
          .reason =
              status.position_jumped ? phrase_of(Reason::position_jumped) : phrase_of(status.fault),
          .fault = status.fault};
}

Phrase fault_sentence(const Interruption& interruption, std::optional<int> trial) {
  const bool by_hand = interruption.fault == Fault::emergency_stop;
  if (!trial) {
    return by_hand ? phrase_of(Reason::stopped_between_trials)
                   : phrase_of(Reason::failed_between_trials).with(interruption.reason);
  }
  const std::string number = std::to_string(*trial);
  return by_hand ? phrase_of(Reason::stopped_in_trial).with(number)
                 : phrase_of(Reason::failed_in_trial).with(number, interruption.reason);
}

SessionCourse::SessionCourse(Study& study, const Protocol& protocol, Rig& rig,
                             Respondent& respondent, SessionRequests& requests,
                             const SessionLinks& links)
    : study_(study),
      protocol_(protocol),
      rig_(rig),
      respondent_(respondent),
      requests_(requests),
      links_(links),
      watch_(links.monitor),
      recorder_(&watch_) {
  assert(!links.last_trial || *links.last_trial >= 1);
}

void SessionCourse::begin(const SessionRow& row) {
  row_ = row;
  phase_ = SessionPhase::idle;
  in_attempt_ = false;
  masking_ = false;
  guiding_ = false;
  has_masked_ = false;
  mask_on_ = false;
  attempt_events_.clear();
  complaints_ = {};
}

// --- time ----------------------------------------------------------------------------------------

void SessionCourse::wait(double duration_s) {
  wait_in_slices(duration_s, [this] { look(false); });
}

void SessionCourse::wait_outside_trial(double duration_s) {
  wait_in_slices(duration_s, [this] { look(true); });
}

void SessionCourse::wait_refusing_answers(double duration_s) {
  wait_in_slices(duration_s, [this] {
    look(false);
    respondent_.refuse_answers();
  });
}

void SessionCourse::wait_in_slices(double duration_s, const std::function<void()>& after_each) {
  double left_s = duration_s;
  do {
    const double slice_s = std::min(left_s, kSlice_s);
    pass(slice_s);
    left_s -= slice_s;
    after_each();
  } while (left_s > 1e-9);
}

void SessionCourse::pass_slice() { pass(kSlice_s); }

void SessionCourse::pass(double duration_s) {
  for (const SessionRequests::ButtonMove& wish : requests_.take_button_moves()) {
    if (wish.move == SessionRequests::Move::press) {
      rig_.hand().press(wish.button);
    } else {
      rig_.hand().release(wish.button);
    }
  }
  rig_.pass(duration_s, recorder_);
  for (const ButtonChange& change : watch_.take_button_changes()) {
    respondent_.button_changed(change);
  }
  if (guiding_) links_.sound->set_guide(watch_.hand().tone());
  if (each_slice_) each_slice_();
  listen_to_device();
  publish_now();
}

void SessionCourse::listen_to_device() {
  const std::int64_t now = now_ns();
  if (!complaints_.is_due(now)) return;
  const std::string complaint = rig_.complaint();
  const DeviceComplaints::News news = complaints_.hear(complaint, now);
  if (news.is_new) {
    update([&](SessionSnapshot& snapshot) {
      if (news.turns) snapshot.device_complains_since_ns = now;
      snapshot.device_complaint = complaint;
    });
  }
  if (!news.is_to_tell) return;
  event(complaint.empty() ? "device_well" : "device_trouble", complaint);
  if (links_.tell)
    links_.tell(complaint.empty() ? "The device no longer reports a problem." : complaint);
}

void SessionCourse::look(bool outside_trial) {
  const ServoStatus status = rig_.loop().status();
  if (status.fault != Fault::none) {
    throw interruption_by(status);
  }
  if (const auto reason = requests_.take_abort()) {
    throw Interruption{AttemptOutcome::aborted, *reason};
  }
  if (in_attempt_) {
    if (const auto reason = requests_.take_skip()) {
      throw Interruption{AttemptOutcome::skipped, *reason};
    }
  }
  if (outside_trial && requests_.take_stop(StopAfter::trial)) {
    throw Interruption{AttemptOutcome::aborted, phrase_of(Reason::as_asked)};
  }
  if (in_attempt_ && has_lost_noise()) {
    const Reason reason = has_masked_ ? Reason::noise_stopped : Reason::no_noise;
    throw Interruption{AttemptOutcome::aborted, phrase_of(reason), links_.experimenter_is_there};
  }
}

void SessionCourse::publish_now() {
  if (links_.monitor == nullptr) return;
  const std::int64_t now = now_ns();
  const Fault fault = rig_.loop().status().fault;
  const double contact_s = recorder_.live().contact_s;
  const bool is_inside = recorder_.live().silent_s >= kUnexplained_s;
  std::optional<LoopHealth> health{};
  if (now - health_shown_ns_ >= kHealthEvery_ns || health_shown_ns_ == 0) {
    health_shown_ns_ = now;
    health = watch_.health();
    health->lost_records = rig_.records().lost();
  }
  const MaskingState masking = masking_state();
  const HandSoFar hand = watch_.hand().so_far();
  links_.monitor->update([&](SessionSnapshot& snapshot) {
    snapshot.now_ns = now;
    snapshot.hand = hand;
    snapshot.fault = fault;
    snapshot.masking = masking;
    snapshot.is_inside = is_inside;
    if (snapshot.surface != 0) snapshot.contact_s = contact_s;
    if (health) snapshot.health = *health;
  });
}

// --- what is seen and heard ----------------------------------------------------------------------

void SessionCourse::enter(SessionPhase phase) {
  if (phase == phase_) return;
  if (links_.monitor != nullptr) event("phase", text_of(phase));
  publish(phase);
}

void SessionCourse::publish(SessionPhase phase) {
  phase_ = phase;
  const std::int64_t now = now_ns();
  const MaskingState masking = masking_state();
  update([&](SessionSnapshot& snapshot) {
    snapshot.masking = masking;
    snapshot.phase = phase;
    snapshot.phase_began_ns = now;
    snapshot.now_ns = now;
  });
}

void SessionCourse::show(ParticipantScene scene) {
  if (links_.monitor == nullptr) return;
  const SessionSnapshot snapshot = links_.monitor->snapshot();
  scene.shown_ns = now_ns();
  scene.language = protocol_.language;
  scene.block = snapshot.block;
  scene.blocks = snapshot.block == 0 ? 0 : snapshot.blocks;
  // A new cue is recognised by its number, which therefore continues from scene to scene.
  scene.cue_number = std::max(scene.cue_number, snapshot.scene->cue_number);
  links_.monitor->show(std::move(scene));
}

void SessionCourse::report_to_experimenter(const std::string& sentence) const {
  if (links_.tell) links_.tell(sentence);
}

void SessionCourse::set_facts(SessionFacts facts) {
  if (links_.monitor != nullptr) links_.monitor->set_facts(std::move(facts));
}

void SessionCourse::set_plan(const Plan& plan) {
  if (links_.monitor == nullptr) return;
  links_.monitor->set_plan(std::make_shared<const Plan>(shown_of(plan)));
}

Plan SessionCourse::shown_of(const Plan& plan) const {
  Plan shown = plan;
  if (!links_.last_trial || plan.trials.empty()) return shown;
  const auto count = static_cast<std::size_t>(*links_.last_trial);
  const auto left_out = std::ranges::find_if(shown.steps, [count](const PlanStep& step) {
    const auto* trial = std::get_if<TrialStep>(&step);
    return trial != nullptr && trial->trial >= count;
  });
  shown.steps.erase(left_out, shown.steps.end());
  shown.trials.resize(std::min(count, plan.trials.size()));
  shown.blocks = last_shown_block(plan);
  return shown;
}

int SessionCourse::last_shown_block(const Plan& plan) const {
  if (!links_.last_trial || plan.trials.empty()) return plan.blocks;
  const auto count = static_cast<std::size_t>(*links_.last_trial);
  return plan.trials[std::min(count, plan.trials.size()) - 1].block_ordinal;
}

void SessionCourse::update(const std::function<void(SessionSnapshot&)>& change) {
  if (links_.monitor != nullptr) links_.monitor->update(change);
}

void SessionCourse::add_attempt(AttemptSummary attempt) {
  if (links_.monitor != nullptr) links_.monitor->add_attempt(std::move(attempt));
}

void SessionCourse::play(Cue cue, int number) {
  if (links_.sound != nullptr) links_.sound->play(cue, number);
}

bool SessionCourse::plays_noise() const {
  return links_.sound != nullptr && protocol_.masking_noise.kind != Protocol::Noise::Kind::none;
}

void SessionCourse::set_masking(bool on) {
  if (!plays_noise() || on == masking_) return;
  links_.sound->set_masking(on);
  masking_ = on;
  has_masked_ = has_masked_ || (on && links_.sound->is_running());
  const MaskingState masking = masking_state();
  update([masking](SessionSnapshot& snapshot) { snapshot.masking = masking; });
}

void SessionCourse::set_guiding_tones(bool on) {
  if (links_.sound == nullptr || on == guiding_) return;
  guiding_ = on;
  if (!on) links_.sound->set_guide(GuideTone::none);
}

bool SessionCourse::has_lost_noise() const {
  return plays_noise() && links_.sound->is_heard() && !links_.sound->is_running();
}

MaskingState SessionCourse::masking_state() const {
  if (!plays_noise() || phase_ == SessionPhase::ended) return MaskingState::none;
  if (!links_.sound->is_heard()) {
    return links_.sound->is_attested() ? MaskingState::elsewhere : MaskingState::no_card;
  }
  if (!links_.sound->is_running()) return MaskingState::silent;
  return masking_ ? MaskingState::on : MaskingState::off;
}

bool SessionCourse::asks_experimenter() const {
  return links_.experimenter_is_there && respondent_.leaves_prompts_to_experimenter();
}

void SessionCourse::ask_experimenter(const Phrase& prompt, const Wait& waiting) {
  if (!asks_experimenter()) {
    show(scene_to_read(prompt.english()));
    respondent_.read(prompt.english(), 0.0, waiting);
    return;
  }
  // The prompt is removed however the wait ends.
  struct Shown {
    explicit Shown(SessionCourse& shown_course, const Phrase& prompt_text) : course(shown_course) {
      course.update([&](SessionSnapshot& snapshot) {
        snapshot.trouble =
            SessionTrouble{prompt_text, course.now_ns(), SessionTrouble::Remedy::confirm};
      });
    }
    ~Shown() {
      course.update([](SessionSnapshot& snapshot) { snapshot.trouble.reset(); });
    }
    Shown(const Shown&) = delete;
    Shown& operator=(const Shown&) = delete;
    SessionCourse& course;
  };
  show({});
  requests_.take_confirmation();  // discards a confirmation from before the prompt
  const Shown shown(*this, prompt);
  while (!requests_.take_confirmation()) waiting(kSlice_s);
  event("experimenter_ready", prompt);
}

void SessionCourse::put_mask(bool on, const Wait& waiting) {
  if (on == mask_on_ || !respondent_.wears_mask() || protocol_.vision != Vision::blindfold) return;
  show(scene_of_mask(on));
  respondent_.put_mask(on, waiting);
  mask_on_ = on;
  event(on ? "mask_on" : "mask_off", "");
}

// --- what is written down ------------------------------------------------------------------------

void SessionCourse::event(const std::string& kind, const Phrase& text,
                          const std::string& data_json) {
  EventRow row = event_row(now_ns(), kind, text, data_json);
  if (in_attempt_) {
    attempt_events_.push_back(std::move(row));
  } else {
    study_.add_event(row_.id, row);
  }
}

void SessionCourse::store_remarks() {
  for (const SessionRequests::Remark& remark : requests_.take_remarks()) {
    study_.add_event(row_.id, event_row(remark.time_ns == 0 ? now_ns() : remark.time_ns,
                                        remark.kind, remark.text));
  }
}

void SessionCourse::store_respondent_events() {
  for (const EventRow& row : respondent_.take_events()) study_.add_event(row_.id, row);
}

void SessionCourse::begin_attempt() {
  store_respondent_events();
  attempt_events_.clear();
  in_attempt_ = true;
  requests_.take_skip();  // discards a skip requested between trials
}

std::vector<EventRow> SessionCourse::take_attempt_events() {
  in_attempt_ = false;
  std::vector<EventRow> events = std::exchange(attempt_events_, {});
  for (EventRow& row : respondent_.take_events()) events.push_back(std::move(row));
  std::stable_sort(events.begin(), events.end(), [](const EventRow& one, const EventRow& other) {
    return one.time_ns < other.time_ns;
  });
  return events;
}

}  // namespace asperity
