// What the monitor of the session reports, written into the experimenter's window.

#include <utility>

#include "app/gui/look/controls.h"
#include "app/gui/session/answers_panel.h"
#include "app/gui/session/health_line.h"
#include "app/gui/session/live_plots.h"
#include "app/gui/session/notes_panel.h"
#include "app/gui/session/plan_table.h"
#include "app/gui/session/session_clock.h"
#include "app/gui/session/session_controls.h"
#include "app/gui/session/session_header.h"
#include "app/gui/session/session_parts.h"
#include "app/gui/session/session_text.h"
#include "app/gui/session/session_troubles.h"
#include "app/gui/session/session_window.h"
#include "app/gui/session/track_panel.h"
#include "app/gui/session/trial_under_way.h"
#include "app/session/rig/clock.h"

namespace asperity {

namespace {

constexpr int kReadable_ms = 250;  // numbers that change faster cannot be read

}  // namespace

bool SessionWindow::is_running() const { return facts_ != nullptr && !ended_ && !failed_; }

bool SessionWindow::is_preparing() const { return facts_ == nullptr && !ended_ && !failed_; }

void SessionWindow::refresh() {
  SessionSnapshot snapshot = monitor_.snapshot();
  const bool changed = !has_shown_ || snapshot.version != shown_.version;
  if (changed) {
    shown_ = std::move(snapshot);
    has_shown_ = true;
    if (auto facts = monitor_.facts(); facts != facts_) take_facts(std::move(facts));
    take_snapshot();
  }
  write_tracks();
  write_moving_texts();
  write_pending();
  write_controls();
  if (!since_health_.isValid() || since_health_.elapsed() > kReadable_ms) {
    since_health_.start();
    write_health();
    write_left();
  }
  plots_->set_hand(shown_.hand);
  plots_->take_bins(monitor_);
  troubles_->look_again();
  if (shown_.phase == SessionPhase::ended && !ended_) end();
}

void SessionWindow::take_facts(std::shared_ptr<const SessionFacts> facts) {
  const bool has_grown =
      facts_ != nullptr && facts != nullptr && facts->protocol == facts_->protocol;
  facts_ = std::move(facts);
  if (facts_ == nullptr || facts_->plan == nullptr || facts_->protocol == nullptr) return;
  header_->set_facts(facts_);
  if (has_grown) {  // only the plan has further trials
    troubles_->set_facts(facts_);
    plan_->set_facts(facts_);
    return;
  }
  setWindowTitle(tr("%1 – Asperity").arg(header_->title()));
  band_->set_mode(facts_->row.mode);
  troubles_->set_facts(facts_);
  plan_->set_facts(facts_);
  notes_->show_earlier(facts_->earlier_notes);
  plots_->set_patch(facts_->protocol->patch);
  parts_->set_has_tracks(has_running_tracks(*facts_->protocol));
  explored_trial_ = -1;
  write_blindness();
}

void SessionWindow::take_snapshot() {
  if (facts_ == nullptr && shown_.phase != SessionPhase::ended) {
    header_->show_preparation(shown_.compared);
  } else {
    header_->show_progress(shown_);
  }
  plan_->set_attempts(shown_.attempts);
  write_answers();
  show_exploration();
  lock_fields();
  time_left_.take(shown_);
  write_left();
  troubles_->show_snapshot(shown_);
}

void SessionWindow::show_exploration() {
  if (shown_.trial == explored_trial_) return;
  // Between trials the plots have what was felt last, and the bands in which that was to be.
  if (explored_trial_ > 0 && !is_in_trial(shown_)) return;
  explored_trial_ = shown_.trial;
  std::optional<Exploration> exploration{};
  if (const Trial* trial = trial_now(shown_, facts_.get())) {
    if (facts_->protocol->blocks.contains(trial->block)) {
      exploration = exploration_of(*facts_->protocol, *trial);
    }
  }
  plots_->set_exploration(exploration);
}

void SessionWindow::write_moving_texts() {
  const std::int64_t time_ns = now_ns(shown_, facts_.get());
  const double in_phase_s = seconds_between(shown_.phase_began_ns, time_ns);
  const int to_come = trial_to_come(shown_, facts_.get(), requests_.pending());
  if (facts_ == nullptr) {
    header_->show_now(shown_.phase == SessionPhase::ended ? tr("The session did not begin")
                                                          : tr("Preparing the session"));
  } else {
    header_->show_now(SessionText::of_now(shown_, trial_now(shown_, facts_.get()), to_come,
                                          plan_->model().condition(shown_.trial, shown_.surface),
                                          in_phase_s));
  }
  plan_->set_now(to_come, SessionText::of_phase(shown_, in_phase_s));
  header_->show_elapsed(
      facts_ == nullptr ? 0.0 : facts_->earlier_s + seconds_between(shown_.began_ns, time_ns));
}

void SessionWindow::write_left() { header_->show_left(time_left_.text(shown_, facts_.get())); }

void SessionWindow::write_pending() {
  const SessionRequests::Pending pending = requests_.pending();
  QStringList words{};
  if (is_running()) {
    if (shown_.phase == SessionPhase::paused) {
      words += pending.pause ? tr("Paused since %1; resume with F5")
                                   .arg(text_of_clock(shown_.phase_began_ns, shown_, facts_.get()))
                             : tr("Resuming");
    } else if (pending.pause) {
      words += tr("Pausing after this trial");
    }
    if (pending.stop == StopAfter::trial) words += tr("Stopping after this trial");
    if (pending.stop == StopAfter::block) words += tr("Stopping after this block");
    if (pending.repeat_last) words += tr("Repeating the last trial next");
    if (troubles_->is_clearing()) words += tr("Clearing the fault");
  }
  header_->show_pending(words.join(" · "));
}

void SessionWindow::write_controls() {
  const SessionRequests::Pending pending = requests_.pending();
  ControlState state{};
  state.running = is_running();
  state.preparing = is_preparing();
  state.only_tried = only_tried_;
  state.cancelling = is_preparing() && cancelling_;
  state.paused = shown_.phase == SessionPhase::paused;
  state.pause_pending = pending.pause;
  state.stop_pending = pending.stop;
  state.repeat_pending = pending.repeat_last;
  state.trial_done = !shown_.attempts->empty();
  state.refreshing = shown_.purpose == AttemptPurpose::refresher;
  state.in_trial = is_in_trial(shown_);
  state.in_fault = shown_.phase == SessionPhase::fault;
  state.note_locked = notes_->is_locked();
  controls_->show_state(state);
  header_->set_running(state.running);
}

void SessionWindow::write_answers() { answers_->show_answers(*shown_.attempts, plan_->model()); }

/// At every frame, because the part can be shown without a change of the snapshot. Computed anew only where it is seen, and
/// only after an attempt or in a further block: a posterior takes some milliseconds.
void SessionWindow::write_tracks() {
  if (shown_.block != 0) latest_block_ = shown_.block;
  if (blind_ || latest_block_ == 0 || !tracks_->isVisibleTo(this)) return;
  if (facts_ == nullptr || facts_->protocol == nullptr || facts_->plan == nullptr) return;
  if (tracked_attempts_ == shown_.attempts && tracked_block_ == latest_block_) return;
  tracked_attempts_ = shown_.attempts;
  tracked_block_ = latest_block_;
  tracks_->show_tracks(
      running_tracks(*facts_->protocol, *facts_->plan, *shown_.attempts, latest_block_));
}

void SessionWindow::write_health() { health_->show_health(shown_, facts_.get(), only_tried_); }

}  // namespace asperity
