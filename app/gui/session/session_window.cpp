#include "app/gui/session/session_window.h"

#include <algorithm>
#include <utility>

#include <QtCore/QTime>
#include <QtCore/QTimer>
#include <QtGui/QCloseEvent>
#include <QtGui/QGuiApplication>
#include <QtGui/QScreen>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QStackedWidget>

#include "app/gui/look/controls.h"
#include "app/gui/look/words.h"
#include "app/gui/session/answers_panel.h"
#include "app/gui/session/end_summary.h"
#include "app/gui/session/health_line.h"
#include "app/gui/session/live_plots.h"
#include "app/gui/session/notes_panel.h"
#include "app/gui/session/plan_table.h"
#include "app/gui/session/reason_form.h"
#include "app/gui/session/session_clock.h"
#include "app/gui/session/session_controls.h"
#include "app/gui/session/session_header.h"
#include "app/gui/session/session_parts.h"
#include "app/gui/session/session_questions.h"
#include "app/gui/session/session_text.h"
#include "app/gui/session/session_troubles.h"
#include "app/gui/session/window_place.h"
#include "app/session/rig/clock.h"
#include "app/words/offered_reasons.h"

namespace asperity {

namespace {

// A little faster than 60 Hz, so that no bin waits for two frames.
constexpr int kSessionFrame_ms = 16;
// What the narrowest form needs in German.
constexpr QSize kSmallest{672, 560};
constexpr int kReadable_ms = 250;  // numbers that change faster cannot be read

QLabel* make_small_heading(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setFont(text_font(TextSize::small, true));
  label->setProperty("role", "muted");
  return label;
}

}  // namespace

SessionWindow::SessionWindow(SessionMonitor& monitor, SessionRequests& requests,
                             std::filesystem::path study, QWidget* parent)
    : QWidget(parent, Qt::Window),
      monitor_(monitor),
      requests_(requests),
      study_(std::move(study)) {
  setObjectName("session_window");
  setWindowTitle(tr("Session – Asperity"));
  setFocusPolicy(Qt::StrongFocus);
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(0, 0, 0, 0);
  outer->setSpacing(0);
  band_ = new ModeBand(this);
  outer->addWidget(band_);
  auto* rows = new QVBoxLayout();
  rows->setContentsMargins(kMargin, kGrid, kMargin, kGrid);
  rows->setSpacing(kGrid);
  outer->addLayout(rows, 1);
  header_ = new SessionHeader(this);
  rows->addWidget(header_);
  troubles_ = new SessionTroubles(requests_, *rows, this);
  reason_ = new ReasonForm(this);
  rows->addWidget(reason_);
  questions_ = new SessionQuestions(requests_, *reason_, *this);
  pages_ = new QStackedWidget(this);
  // Of all rows it is the one that gives way.
  pages_->setMinimumHeight(1);
  make_middle();
  summary_ = new EndSummary(study_, pages_);
  pages_->addWidget(summary_);
  rows->addWidget(pages_, 1);
  health_ = new HealthLine(this);
  rows->addWidget(health_);
  controls_ = new SessionControls(this);
  rows->addWidget(controls_);
  keys_ = new SessionKeys(this);
  connect_parts();

  // What stands in it must not change its size under the experimenter's hand.
  outer->setSizeConstraint(QLayout::SetNoConstraint);
  setMinimumSize(kSmallest);
  place_ = new WindowPlace(*this);
  // Not to the first button: the participant's Space would press it.
  setFocus();
  resize(1366, 720);
  fit_form();
  write_blindness();
  refresh();
  auto* frames = new QTimer(this);
  frames->setTimerType(Qt::PreciseTimer);
  connect(frames, &QTimer::timeout, this, &SessionWindow::refresh);
  frames->start(kSessionFrame_ms);
}

SessionWindow::~SessionWindow() = default;

// --- what it is made of --------------------------------------------------------------------------

void SessionWindow::connect_parts() {
  connect(keys_, &SessionKeys::emergency, this, &SessionWindow::do_emergency_stop);
  connect(keys_, &SessionKeys::wanted, this, &SessionWindow::do_verb);
  connect(header_, &SessionHeader::emergency, this, &SessionWindow::do_emergency_stop);
  connect(controls_, &SessionControls::wanted, this, &SessionWindow::do_verb);
  connect(controls_, &SessionControls::skip_wanted, this,
          [this] { questions_->ask_to_skip(shown_.trial); });
  connect(header_, &SessionHeader::unblind_pressed, this, &SessionWindow::change_blindness);
  connect(notes_, &NotesPanel::noted, this, [this](const QString& text) {
    requests_.note(offered_or_typed(text, offered_reasons(ReasonFor::noting)));
  });
  connect(troubles_, &SessionTroubles::end_wanted, this, [this] { do_verb(SessionVerb::abort); });
  connect(troubles_, &SessionTroubles::pause_wanted, this, [this] { do_verb(SessionVerb::pause); });
  connect(troubles_, &SessionTroubles::way_on_wanted, this, &SessionWindow::way_on_wanted);
  connect(troubles_, &SessionTroubles::participant_screen_back, this,
          &SessionWindow::participant_screen_back);
  connect(questions_, &SessionQuestions::leaving, this, [this] { close_when_ended_ = true; });
  connect(summary_, &EndSummary::trials_wanted, this, &SessionWindow::trials_wanted);
  connect(summary_, &EndSummary::results_wanted, this, &SessionWindow::results_wanted);
  connect(summary_, &EndSummary::way_on_wanted, this, &SessionWindow::way_on_wanted);
  connect(summary_, &EndSummary::close_wanted, this, &QWidget::close);
  connect(qGuiApp, &QGuiApplication::screenRemoved, this, &SessionWindow::screen_left);
}

void SessionWindow::make_middle() {
  plan_ = new PlanTable(pages_);
  plots_ = new LivePlots(pages_);
  answers_ = new AnswersPanel(pages_);
  notes_ = new NotesPanel(pages_);
  parts_ = new SessionParts(
      {.plan = plan_, .plots = plots_, .sight = make_sight(), .answers = answers_, .notes = notes_},
      pages_);
  pages_->addWidget(parts_);
}

QWidget* SessionWindow::make_sight() {
  auto* sight = new QWidget(pages_);
  auto* rows = new QVBoxLayout(sight);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(kGrid / 2);
  rows->addWidget(make_small_heading(tr("PARTICIPANT'S VIEW"), sight));
  QVBoxLayout* frame = nullptr;
  QFrame* screen = make_card(sight, frame);
  frame->setContentsMargins(1, 1, 1, 1);
  screen->setMinimumHeight(72);
  mirror_place_ = frame;
  mirror_ = make_text(tr("The participant's window is not open."), screen, true);
  static_cast<QLabel*>(mirror_)->setAlignment(Qt::AlignCenter);
  mirror_place_->addWidget(mirror_);
  rows->addWidget(screen, 1);
  return sight;
}

void SessionWindow::set_mirror(QWidget* mirror) {
  delete mirror_;
  mirror_ = mirror;
  mirror_place_->addWidget(mirror_);
}

void SessionWindow::set_participant_window(bool there) { controls_->set_participant_window(there); }

void SessionWindow::fit_form() {
  const SessionForm form = form_for(width(), height());
  // What has come to an end needs no health, and its summary the room.
  health_->setHidden(ended_ && form == SessionForm::narrow);
  header_->set_form(form);
  parts_->set_form(form);
  health_->set_form(form);
  controls_->set_form(form);
  // At once: nothing is seen at a size that was another form's.
  for (QWidget* row : {static_cast<QWidget*>(header_), static_cast<QWidget*>(health_),
                       static_cast<QWidget*>(controls_)}) {
    row->layout()->activate();
    row->updateGeometry();
  }
  layout()->activate();
}

void SessionWindow::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fit_form();
}

void SessionWindow::set_own_keyboard(bool own) {
  own_keyboard_ = own;
  lock_fields();
  refresh();
}

// --- what the experimenter asks for --------------------------------------------------------------

void SessionWindow::do_emergency_stop() {
  requests_.emergency_stop();
  if (ended_) return;
  // What was being asked is of no matter now, and would stand in the way of what is.
  questions_->take_all_back();
  troubles_->show_emergency();
}

void SessionWindow::do_verb(SessionVerb verb) {
  // Also while the session is being prepared.
  if (verb == SessionVerb::show_participant) return emit participant_window_wanted();
  if (is_preparing() && verb == SessionVerb::abort && !cancelling_) {
    cancelling_ = true;
    write_controls();
    return emit cancel_wanted();
  }
  if (!is_running()) return;
  const SessionRequests::Pending pending = requests_.pending();
  const auto toggle_stop = [&](StopAfter what) {
    if (pending.stop == what) {
      requests_.go_on();
    } else {
      requests_.stop_after(what);
    }
  };
  switch (verb) {
    case SessionVerb::start_or_resume:
      requests_.resume();
      requests_.confirm();
      break;
    case SessionVerb::leave_or_pause:
      if (questions_->take_back_one()) break;
      requests_.pause();
      break;
    case SessionVerb::pause:
      requests_.pause();
      break;
    case SessionVerb::stop_after_trial:
      toggle_stop(StopAfter::trial);
      break;
    case SessionVerb::stop_after_block:
      toggle_stop(StopAfter::block);
      break;
    case SessionVerb::repeat_last:
      if (shown_.attempts->empty() || pending.repeat_last) break;
      if (field_lock().isEmpty()) take_keyboard();
      questions_->ask_to_repeat();
      break;
    case SessionVerb::note:
      if (notes_->is_locked()) break;
      take_keyboard();
      parts_->show_part(SessionParts::Part::notes);
      notes_->focus_field();
      break;
    case SessionVerb::abort:
      questions_->ask_to_abort();
      break;
    case SessionVerb::show_participant:
      break;
  }
  refresh();
}

/// What is typed next is meant for this window, whichever had the focus when the key was pressed: in
/// the participant's it would be an answer.
void SessionWindow::take_keyboard() {
  raise();
  activateWindow();
}

// --- who may know what ---------------------------------------------------------------------------

void SessionWindow::change_blindness() {
  if (facts_ == nullptr) return;
  const bool is_run = facts_->row.mode == SessionMode::run;
  if (!blind_) {
    blind_ = true;
    if (is_run) requests_.remark("blinded_again", "");
    return write_blindness();
  }
  if (!is_run) {
    blind_ = false;
    return write_blindness();
  }
  questions_->ask_to_unblind([this](const Phrase& reason) {
    requests_.remark("unblinded", reason);
    if (unblinded_at_.isEmpty()) unblinded_at_ = QTime::currentTime().toString("HH:mm");
    blind_ = false;
    write_blindness();
  });
}

void SessionWindow::write_blindness() {
  header_->show_blindness({.is_blind = blind_,
                           .is_run = facts_ == nullptr || facts_->row.mode == SessionMode::run,
                           .can_change = facts_ != nullptr,
                           .unblinded_at = unblinded_at_});
  plan_->set_blind(blind_);
  plots_->set_blind(blind_);
  troubles_->set_blind(blind_);
  write_answers();
}

QString SessionWindow::field_lock() const {
  if (ended_) return tr("The session has ended");
  if (!own_keyboard_ && shown_.scene->response_open) return tr("Keys reserved for the response");
  return {};
}

void SessionWindow::lock_fields() {
  const QString why = field_lock();
  notes_->lock(why);
  questions_->lock(why);
}

// --- what the monitor says -----------------------------------------------------------------------

bool SessionWindow::is_running() const { return facts_ != nullptr && !ended_ && !failed_; }

bool SessionWindow::is_preparing() const { return facts_ == nullptr && !ended_ && !failed_; }

bool SessionWindow::is_in_trial() const {
  return shown_.phase == SessionPhase::fore || shown_.phase == SessionPhase::contact ||
         shown_.phase == SessionPhase::response;
}

/// The one under way; between trials the one that comes, as far as the experimenter has not asked for
/// another.
int SessionWindow::trial_to_come() const {
  if (shown_.phase == SessionPhase::ended) return 0;
  if (is_in_trial()) return shown_.trial;
  const SessionRequests::Pending pending = requests_.pending();
  if (pending.stop == StopAfter::trial) return 0;
  if (pending.repeat_last && shown_.last_done != 0) return shown_.last_done;
  const Trial* next = trial_now();
  if (pending.stop == StopAfter::block && next != nullptr && !shown_.attempts->empty() &&
      next->block_ordinal != shown_.block) {
    return 0;
  }
  return shown_.trial;
}

const Trial* SessionWindow::trial_now() const {
  if (facts_ == nullptr || facts_->plan == nullptr || shown_.trial < 1) return nullptr;
  const auto& trials = facts_->plan->trials;
  const auto number = static_cast<std::size_t>(shown_.trial);
  return number <= trials.size() ? &trials[number - 1] : nullptr;
}

void SessionWindow::refresh() {
  SessionSnapshot snapshot = monitor_.snapshot();
  const bool changed = !has_shown_ || snapshot.version != shown_.version;
  if (changed) {
    shown_ = std::move(snapshot);
    has_shown_ = true;
    if (auto facts = monitor_.facts(); facts != facts_) take_facts(std::move(facts));
    take_snapshot();
  }
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
  facts_ = std::move(facts);
  if (facts_ == nullptr || facts_->plan == nullptr || facts_->protocol == nullptr) return;
  header_->set_facts(facts_);
  setWindowTitle(tr("%1 – Asperity").arg(header_->title()));
  band_->set_mode(facts_->row.mode);
  troubles_->set_facts(facts_);
  plan_->set_facts(facts_);
  notes_->show_earlier(facts_->earlier_notes);
  plots_->set_patch(facts_->protocol->patch);
  explored_trial_ = -1;
  write_blindness();
}

void SessionWindow::take_snapshot() {
  if (facts_ == nullptr && shown_.phase != SessionPhase::ended) {
    header_->show_preparation(shown_.compared);
  } else {
    header_->show_progress(shown_);
  }
  plan_->model().set_attempts(shown_.attempts);
  write_answers();
  show_exploration();
  lock_fields();
  if (shown_.expected_left_s != left_s_) {
    left_s_ = shown_.expected_left_s;
    left_since_ns_ = shown_.now_ns;
  }
  write_left();
  troubles_->show_snapshot(shown_);
}

void SessionWindow::show_exploration() {
  if (shown_.trial == explored_trial_) return;
  // Between trials the plots have what was felt last, and the bands in which that was to be.
  if (explored_trial_ > 0 && !is_in_trial()) return;
  explored_trial_ = shown_.trial;
  std::optional<Exploration> exploration{};
  if (const Trial* trial = trial_now()) {
    if (facts_->protocol->blocks.contains(trial->block)) {
      exploration = exploration_of(*facts_->protocol, *trial);
    }
  }
  plots_->set_exploration(exploration);
}

void SessionWindow::write_moving_texts() {
  const std::int64_t time_ns = now_ns(shown_, facts_.get());
  const double in_phase_s = seconds_between(shown_.phase_began_ns, time_ns);
  if (facts_ == nullptr) {
    header_->show_now(shown_.phase == SessionPhase::ended ? tr("The session did not begin")
                                                          : tr("Preparing the session"));
  } else {
    header_->show_now(SessionText::of_now(shown_, trial_now(), trial_to_come(),
                                          plan_->model().condition(shown_.trial, shown_.surface),
                                          in_phase_s));
  }
  plan_->set_now(trial_to_come(), SessionText::of_phase(shown_, in_phase_s));
  header_->show_elapsed(
      facts_ == nullptr ? 0.0 : facts_->earlier_s + seconds_between(shown_.began_ns, time_ns));
}

/// A simulated clock runs at its own pace: there, no time of day can be said.
void SessionWindow::write_left() {
  if (shown_.phase == SessionPhase::ended) return header_->show_left({});
  if (!left_s_ || facts_ == nullptr || facts_->row.pacing != "real_time") {
    return header_->show_left(SessionText::of_left(left_s_, {}));
  }
  const std::int64_t time_ns = now_ns(shown_, facts_.get());
  const bool stands_still =
      shown_.phase == SessionPhase::paused || shown_.phase == SessionPhase::fault;
  if (stands_still) left_since_ns_ = time_ns;
  const std::int64_t end_ns =
      std::max(time_ns, left_since_ns_ + static_cast<std::int64_t>(1e9 * *left_s_));
  header_->show_left(SessionText::of_left(seconds_between(time_ns, end_ns),
                                          text_of_clock(end_ns, shown_, facts_.get())));
}

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
  state.cancelling = is_preparing() && cancelling_;
  state.paused = shown_.phase == SessionPhase::paused;
  state.pause_pending = pending.pause;
  state.stop_pending = pending.stop;
  state.repeat_pending = pending.repeat_last;
  state.trial_done = !shown_.attempts->empty();
  state.in_trial = is_in_trial();
  state.in_fault = shown_.phase == SessionPhase::fault;
  state.note_locked = notes_->is_locked();
  controls_->show_state(state);
  header_->set_running(state.running);
}

void SessionWindow::write_answers() { answers_->show_answers(*shown_.attempts, plan_->model()); }

void SessionWindow::write_health() { health_->show_health(shown_, facts_.get()); }

// --- the end -------------------------------------------------------------------------------------

void SessionWindow::end() {
  ended_ = true;
  keys_->switch_off();
  questions_->end();
  lock_fields();
  write_controls();
  write_pending();
  write_health();
  header_->show_progress(shown_);
  write_left();
  troubles_->end();
  write_end();
  pages_->setCurrentWidget(summary_);
  controls_->hide();
  fit_form();
  if (close_when_ended_) close();
}

void SessionWindow::write_end() {
  SessionOutcome outcome{};
  outcome.is_complete =
      end_ ? end_->state == SessionState::completed
           : shown_.trials > 0 && shown_.trials_done >= shown_.trials && !shown_.trouble;
  outcome.can_go_on =
      facts_ != nullptr && !outcome.is_complete && !(end_ && end_->as_the_protocol_says);
  QString why{};
  if (end_ && !end_->reason.empty()) {
    why = words_of(end_->reason);
  } else if (shown_.trouble && !failed_) {  // a failure is said by its banner
    why = words_of(shown_.trouble->what);
  }
  if (!why.isEmpty()) outcome.why = tr("Reason: %1").arg(troubles_->veiled(why));
  summary_->show_end(shown_, facts_ == nullptr ? SessionRow{} : facts_->row, outcome);
}

void SessionWindow::show_end(const SessionEnd& how) {
  end_ = how;
  shown_ = monitor_.snapshot();
  end();
}

void SessionWindow::show_failure(const QString& what, AfterFailure next) {
  failed_ = true;
  keys_->switch_off();
  questions_->end();
  troubles_->show_failure(what, next);
  write_controls();
  if (ended_) write_end();
}

bool SessionWindow::may_close() {
  // Also while the session is still being prepared: nobody would see it begin.
  if (ended_ || failed_) return true;
  questions_->ask_to_leave();
  return false;
}

void SessionWindow::closeEvent(QCloseEvent* event) {
  if (!may_close()) return event->ignore();
  event->accept();
  if (!closed_) {
    closed_ = true;
    emit closed();
  }
}

void SessionWindow::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  // Texts that carry a colour are written again in those of the new look.
  if (event->type() == QEvent::PaletteChange && plots_ != nullptr && has_shown_) {
    if (facts_ != nullptr) band_->set_mode(facts_->row.mode);
    write_blindness();
    write_health();
  }
}

/// Focus that its widget loses by going away goes to no other: the next one is a button as likely as
/// not, and would hear the participant's Space.
bool SessionWindow::focusNextPrevChild(bool next) {
  const QWidget* focus = focusWidget();
  const bool by_tab = focus == nullptr || (focus->isVisible() && focus->isEnabled());
  if (by_tab) return QWidget::focusNextPrevChild(next);
  setFocus();
  return true;
}

void SessionWindow::tell_device_wish(const QString& sentence) {
  if (!failed_ && !ended_ && facts_ == nullptr) troubles_->show_told(sentence);
}

void SessionWindow::tell_screen_lost(const QString& name, ScreenLoss loss) {
  troubles_->show_participant_screen_lost(name, loss);
}

void SessionWindow::screen_left(QScreen* screen) {
  troubles_->show_screen_removed(screen == nullptr ? QString() : screen->name());
  // After Qt has dealt with it: it may have put the window where no screen is.
  QTimer::singleShot(0, this, [this] {
    const QPoint middle = frameGeometry().center();
    if (QGuiApplication::screenAt(middle) != nullptr) return;
    if (QScreen* remaining = QGuiApplication::primaryScreen()) {
      const QRect room = remaining->availableGeometry();
      resize(size().boundedTo(room.size()));
      move(room.topLeft());
    }
  });
}

}  // namespace asperity

#include "moc_session_window.cpp"
