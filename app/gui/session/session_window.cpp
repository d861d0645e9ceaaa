#include "app/gui/session/session_window.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include <QtCore/QDateTime>
#include <QtCore/QTimer>
#include <QtGui/QCloseEvent>
#include <QtGui/QGuiApplication>
#include <QtGui/QScreen>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QProgressBar>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QStackedWidget>

#include "app/gui/look/controls.h"
#include "app/gui/look/outcome_words.h"
#include "app/gui/session/answers_panel.h"
#include "app/gui/session/end_summary.h"
#include "app/gui/session/fault_panel.h"
#include "app/gui/session/health_line.h"
#include "app/gui/session/live_plots.h"
#include "app/gui/session/notes_panel.h"
#include "app/gui/session/plan_table.h"
#include "app/gui/session/reason_form.h"
#include "app/gui/session/session_controls.h"
#include "app/gui/session/session_dialogs.h"

namespace asperity {

namespace {

constexpr int kFrame_ms = 16;  // a little faster than 60 Hz, so that no bin waits for two frames
constexpr int kReadable_ms = 250;  // numbers that change faster cannot be read
// A fault that is still there after this was not cleared.
constexpr int kClearing_ms = 3000;

double seconds_between(std::int64_t from_ns, std::int64_t to_ns) {
  return 1e-9 * static_cast<double>(to_ns - from_ns);
}

void set_if_new(QLabel& label, const QString& text) {
  if (label.text() != text) label.setText(text);
}

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
  rows->addLayout(make_header());
  rows->addLayout(make_now_line());
  fault_ = new FaultPanel(this);
  trouble_ = new Banner(this);
  trouble_->setObjectName("trouble");
  news_ = new Banner(this);
  news_->setObjectName("news");
  reason_ = new ReasonForm(this);
  for (QWidget* below : {static_cast<QWidget*>(fault_), static_cast<QWidget*>(trouble_),
                         static_cast<QWidget*>(news_), static_cast<QWidget*>(reason_)}) {
    rows->addWidget(below);
  }
  pages_ = new QStackedWidget(this);
  pages_->addWidget(make_middle());
  summary_ = new EndSummary(study_, pages_);
  pages_->addWidget(summary_);
  rows->addWidget(pages_, 1);
  health_ = new HealthLine(this);
  rows->addWidget(health_);
  controls_ = new SessionControls(this);
  rows->addWidget(controls_);

  keys_ = new SessionKeys(this);
  connect(keys_, &SessionKeys::emergency, this, &SessionWindow::do_emergency_stop);
  connect(keys_, &SessionKeys::wanted, this, &SessionWindow::do_verb);
  connect(controls_, &SessionControls::emergency, this, &SessionWindow::do_emergency_stop);
  connect(controls_, &SessionControls::wanted, this, &SessionWindow::do_verb);
  connect(controls_, &SessionControls::skip_wanted, this, &SessionWindow::ask_skip);
  connect(notes_, &NotesPanel::noted, this,
          [this](const QString& text) { requests_.note(text.toStdString()); });
  connect(fault_, &FaultPanel::clear_wanted, this, [this] {
    requests_.clear_fault();
    stopped_at_.clear();
    clearing_ = true;
    cleared_trouble_ns_ = shown_.trouble ? shown_.trouble->time_ns : 0;
    since_clearing_.start();
    fault_->hide();
  });
  connect(fault_, &FaultPanel::end_wanted, this, &SessionWindow::ask_abort);
  connect(summary_, &EndSummary::trials_wanted, this, &SessionWindow::trials_wanted);
  connect(summary_, &EndSummary::results_wanted, this, &SessionWindow::results_wanted);
  connect(summary_, &EndSummary::close_wanted, this, &QWidget::close);
  connect(qGuiApp, &QGuiApplication::screenRemoved, this, &SessionWindow::screen_left);

  // Not to the first button: the participant's Space would press it.
  setFocus();
  resize(1366, 720);
  write_blindness();
  refresh();
  auto* frames = new QTimer(this);
  frames->setTimerType(Qt::PreciseTimer);
  connect(frames, &QTimer::timeout, this, &SessionWindow::refresh);
  frames->start(kFrame_ms);
}

SessionWindow::~SessionWindow() = default;

// --- what it is made of --------------------------------------------------------------------------

QLayout* SessionWindow::make_header() {
  auto* row = new QHBoxLayout();
  row->setSpacing(kMargin);
  title_ = make_heading(tr("Session"), this);
  title_->setObjectName("session_title");
  title_->setWordWrap(false);
  title_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  title_->installEventFilter(this);
  blindness_ = new QLabel(this);
  blindness_->setObjectName("blindness");
  unblind_ = make_button({}, ButtonRole::plain, this);
  unblind_->setObjectName("unblind");
  unblind_->setFocusPolicy(Qt::TabFocus);
  connect(unblind_, &QPushButton::clicked, this, [this] {
    if (!blind_) {
      blind_again();
    } else {
      ask_unblind();
    }
  });
  row->addWidget(title_, 1);
  row->addWidget(blindness_);
  row->addWidget(unblind_);
  return row;
}

QLayout* SessionWindow::make_now_line() {
  auto* rows = new QVBoxLayout();
  rows->setSpacing(kGrid / 2);
  auto* counts = new QHBoxLayout();
  counts->setSpacing(kGroupGap);
  block_ = new QLabel(this);
  block_->setObjectName("block");
  progress_ = new QProgressBar(this);
  progress_->setTextVisible(false);
  progress_->setObjectName("progress");
  trial_ = new QLabel(this);
  trial_->setObjectName("trial");
  elapsed_ = new QLabel(this);
  elapsed_->setObjectName("elapsed");
  left_ = new QLabel(this);
  left_->setObjectName("left");
  counts->addWidget(block_);
  counts->addWidget(progress_, 1);
  for (QLabel* label : {trial_, elapsed_, left_}) counts->addWidget(label);
  rows->addLayout(counts);
  auto* now = new QHBoxLayout();
  now->setSpacing(kGroupGap);
  now_ = new QLabel(this);
  now_->setObjectName("now");
  now_->setFont(text_font(TextSize::heading, true));
  now_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  pending_ = new StateLabel(this);
  pending_->setObjectName("pending");
  pending_->setFont(text_font(TextSize::heading, true));
  pending_->setWordWrap(false);
  pending_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  now->addWidget(now_, 1);
  now->addWidget(pending_);
  rows->addLayout(now);
  return rows;
}

QWidget* SessionWindow::make_middle() {
  auto* middle = new QWidget(this);
  auto* columns = new QHBoxLayout(middle);
  columns->setContentsMargins(0, 0, 0, 0);
  columns->setSpacing(kMargin);
  plan_ = new PlanTable(middle);
  plots_ = new LivePlots(middle);
  auto* right = new QWidget(middle);
  auto* rows = new QVBoxLayout(right);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(kGrid / 2);
  rows->addWidget(make_small_heading(tr("PARTICIPANT SEES"), right));
  QVBoxLayout* frame = nullptr;
  QFrame* screen = make_card(right, frame);
  frame->setContentsMargins(1, 1, 1, 1);
  screen->setMinimumHeight(72);
  mirror_place_ = frame;
  mirror_ = make_text(tr("The participant's window is not open."), screen, true);
  static_cast<QLabel*>(mirror_)->setAlignment(Qt::AlignCenter);
  mirror_place_->addWidget(mirror_);
  rows->addWidget(screen, 5);
  answers_ = new AnswersPanel(right);
  rows->addWidget(answers_);
  rows->addSpacing(kGrid);
  notes_ = new NotesPanel(right);
  rows->addWidget(notes_, 4);
  columns->addWidget(plan_, 40);
  columns->addWidget(plots_, 52);
  columns->addWidget(right, 38);
  for (QWidget* column : {static_cast<QWidget*>(plan_), static_cast<QWidget*>(plots_), right}) {
    // The widths are shared out as said, whatever stands in the columns.
    column->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Expanding);
    column->setMinimumWidth(320);
  }
  return middle;
}

void SessionWindow::set_mirror(QWidget* mirror) {
  delete mirror_;
  mirror_ = mirror;
  mirror_place_->addWidget(mirror_);
}

void SessionWindow::set_own_keyboard(bool own) {
  own_keyboard_ = own;
  refresh();
}

// --- what the experimenter asks for --------------------------------------------------------------

void SessionWindow::do_emergency_stop() {
  requests_.emergency_stop();
  if (ended_) return;
  stopped_at_ = QTime::currentTime().toString("HH:mm:ss");
  clearing_ = false;
  // What was being asked is of no matter now, and would stand in the way of what is.
  if (dialog_ != nullptr) dialog_->reject();
  reason_->cancel();
  write_trouble();
}

void SessionWindow::do_verb(SessionVerb verb) {
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
      if (dialog_ != nullptr && dialog_->isVisible()) {
        dialog_->reject();
        break;
      }
      if (reason_->isVisible()) {
        reason_->cancel();
        break;
      }
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
      ask_repeat();
      break;
    case SessionVerb::note:
      if (notes_->is_locked()) break;
      take_keyboard();
      notes_->focus_field();
      break;
    case SessionVerb::abort:
      ask_abort();
      break;
  }
  refresh();
}

void SessionWindow::ask_repeat() {
  if (shown_.attempts->empty() || requests_.pending().repeat_last) return;
  if (field_lock().isEmpty()) take_keyboard();
  reason_->lock(field_lock());
  reason_->ask(tr("Why is the last trial repeated? What was answered stays stored and no longer "
                  "counts."),
               {tr("The participant was distracted"), tr("Wrong key pressed"),
                tr("The participant asks for it"), tr("Technical problem")},
               tr("Repeat last trial"),
               [this](const QString& reason) { requests_.repeat_last(reason.toStdString()); });
}

/// What is typed next is meant for this window, whichever had the focus when the key was pressed: in
/// the participant's it would be an answer.
void SessionWindow::take_keyboard() {
  raise();
  activateWindow();
}

void SessionWindow::ask_skip() {
  reason_->lock(field_lock());
  reason_->ask(
      tr("Why is trial %1 skipped? It is kept as skipped and not asked again.").arg(shown_.trial),
      {tr("The participant cannot answer"), tr("The participant does not want to go on"),
       tr("Technical problem")},
      tr("Skip this trial"),
      [this](const QString& reason) { requests_.skip(reason.toStdString()); });
}

void SessionWindow::ask_abort() {
  if (!is_running()) return;
  if (dialog_ != nullptr && dialog_->isVisible()) return dialog_->raise();
  auto* dialog = new AbortDialog(
      this, [this](const QString& reason) { requests_.abort(reason.toStdString()); });
  dialog->lock(field_lock());
  dialog_ = dialog;
  dialog_->show();
}

void SessionWindow::ask_close() {
  if (dialog_ != nullptr && dialog_->isVisible()) return dialog_->raise();
  dialog_ = new CloseDialog(this, [this](Leaving how) {
    close_when_ended_ = true;
    if (how == Leaving::abort_now) {
      requests_.abort("the session window was closed");
    } else {
      requests_.stop_after(StopAfter::trial);
      // A pause would keep it from ever coming to that.
      requests_.resume();
    }
  });
  dialog_->show();
}

void SessionWindow::ask_unblind() {
  if (facts_ == nullptr) return;
  if (facts_->row.mode != SessionMode::run) {
    blind_ = false;
    write_blindness();
    return;
  }
  reason_->lock(field_lock());
  reason_->ask(tr("Why do you need to know the conditions? The reason is stored with the session, "
                  "and the window stays marked."),
               {tr("Safety of the participant"), tr("Suspected fault of a stimulus"),
                tr("Not the experimenter of this study")},
               tr("Unblind"), [this](const QString& reason) {
                 requests_.remark("unblinded", reason.toStdString());
                 if (unblinded_at_.isEmpty()) {
                   unblinded_at_ = QTime::currentTime().toString("HH:mm");
                 }
                 blind_ = false;
                 write_blindness();
               });
}

void SessionWindow::blind_again() {
  blind_ = true;
  if (facts_ != nullptr && facts_->row.mode == SessionMode::run) {
    requests_.remark("blinded_again", "");
  }
  write_blindness();
}

void SessionWindow::write_blindness() {
  const bool is_run = facts_ == nullptr || facts_->row.mode == SessionMode::run;
  QString words{};
  bool marked = false;
  if (!unblinded_at_.isEmpty()) {
    marked = true;
    words = blind_ ? tr("▲ Blind again; UNBLINDED at %1").arg(unblinded_at_)
                   : tr("▲ UNBLINDED at %1").arg(unblinded_at_);
  } else {
    words = blind_ ? tr("Blind: codes stand for conditions") : tr("Names are shown");
  }
  blindness_->setText(words);
  blindness_->setFont(text_font(TextSize::body, marked));
  blindness_->setStyleSheet(
      QString("color: %1").arg((marked ? theme().look : theme().muted).name()));
  if (blind_) {
    unblind_->setText(is_run ? tr("Unblind…") : tr("Show names"));
  } else {
    unblind_->setText(is_run ? tr("Blind again") : tr("Hide names"));
  }
  unblind_->setEnabled(facts_ != nullptr);
  plan_->set_blind(blind_);
  plots_->set_blind(blind_);
  trouble_shown_.reset();
  write_answers();
  write_trouble();
}

/// Whole in the tool tip; where it does not fit, the protocol's title is what is cut.
void SessionWindow::write_title() {
  if (facts_ == nullptr || facts_->protocol == nullptr) return;
  const SessionRow& row = facts_->row;
  const auto with = [&row](const QString& title) {
    return tr("Session %1 · %2 · %3 · %4")
        .arg(row.session)
        .arg(QString::fromStdString(row.participant), title, SessionText::of_mode(row.mode));
  };
  const QString title = QString::fromStdString(facts_->protocol->title);
  const QFontMetrics letters(title_->font());
  const int room = title_->width() - letters.horizontalAdvance(with({}));
  set_if_new(*title_, with(letters.elidedText(title, Qt::ElideRight, std::max(room, 0))));
  title_->setToolTip(with(title));
}

bool SessionWindow::eventFilter(QObject* watched, QEvent* event) {
  if (watched == title_ && event->type() == QEvent::Resize) write_title();
  return QWidget::eventFilter(watched, event);
}

QString SessionWindow::field_lock() const {
  if (ended_) return tr("The session has ended");
  if (!own_keyboard_ && shown_.scene->response_open) return tr("Keys answer the trial now");
  return {};
}

// --- what the monitor says -----------------------------------------------------------------------

bool SessionWindow::is_running() const { return facts_ != nullptr && !ended_ && !failed_; }

const Trial* SessionWindow::trial_now() const {
  if (facts_ == nullptr || facts_->plan == nullptr || shown_.trial < 1) return nullptr;
  const auto& trials = facts_->plan->trials;
  const auto number = static_cast<std::size_t>(shown_.trial);
  return number <= trials.size() ? &trials[number - 1] : nullptr;
}

std::int64_t SessionWindow::now_ns() const {
  // Only a session in real time goes on between two words of the conductor.
  if (facts_ == nullptr || facts_->row.pacing != "real_time" || ended_) return shown_.now_ns;
  const std::int64_t machine_ns = std::chrono::duration_cast<std::chrono::nanoseconds>(
                                      std::chrono::steady_clock::now().time_since_epoch())
                                      .count();
  return std::max(shown_.now_ns, machine_ns + facts_->clock_ahead_ns);
}

QString SessionWindow::clock_text(std::int64_t time_ns) const {
  return QDateTime::currentDateTime().addMSecs((time_ns - now_ns()) / 1'000'000).toString("HH:mm");
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
  if (!has_shown_ || !since_health_.isValid() || since_health_.elapsed() > kReadable_ms) {
    since_health_.start();
    write_health();
  }
  plots_->take_bins(monitor_);
  if (clearing_ && since_clearing_.elapsed() > kClearing_ms) {
    clearing_ = false;
    write_trouble();
  }
  if (shown_.phase == SessionPhase::ended && !ended_) end();
}

void SessionWindow::take_facts(std::shared_ptr<const SessionFacts> facts) {
  facts_ = std::move(facts);
  if (facts_ == nullptr || facts_->plan == nullptr || facts_->protocol == nullptr) return;
  const SessionRow& row = facts_->row;
  veil_ = NameVeil(*facts_->protocol, *facts_->plan);
  write_title();
  setWindowTitle(tr("%1 – Asperity").arg(title_->toolTip()));
  band_->set_mode(row.mode);
  plan_->set_facts(facts_);
  plots_->set_patch(facts_->protocol->patch);
  explored_trial_ = -1;
  write_blindness();
}

void SessionWindow::take_snapshot() {
  const SessionSnapshot& s = shown_;
  set_if_new(*block_, s.block > 0 ? tr("Block %1 of %2").arg(s.block).arg(s.blocks)
                                  : tr("Blocks: %1").arg(s.blocks));
  progress_->setMaximum(std::max(1, s.trials));
  progress_->setValue(s.trials_done);
  set_if_new(*trial_, s.trial > 0 ? tr("trial %1 of %2").arg(s.trial).arg(s.trials)
                                  : tr("trials: %1").arg(s.trials));
  set_if_new(*left_,
             s.phase == SessionPhase::ended ? QString() : SessionText::of_left(s.expected_left_s));
  plan_->model().set_attempts(s.attempts);
  write_answers();
  if (s.trial != explored_trial_) {
    explored_trial_ = s.trial;
    std::optional<Exploration> exploration{};
    if (const Trial* trial = trial_now()) {
      const auto block = facts_->protocol->blocks.find(trial->block);
      if (block != facts_->protocol->blocks.end() && !block->second.exploration.empty()) {
        exploration = facts_->protocol->explorations.at(block->second.exploration);
      }
    }
    plots_->set_exploration(exploration);
  }
  const QString lock = field_lock();
  notes_->lock(lock);
  reason_->lock(lock);
  if (auto* abort = qobject_cast<AbortDialog*>(dialog_.data())) abort->lock(lock);
  const bool is_cleared = s.phase != SessionPhase::fault && s.fault == Fault::none;
  const bool has_failed = s.trouble && s.trouble->time_ns != cleared_trouble_ns_;
  if (clearing_ && (is_cleared || has_failed)) clearing_ = false;
  write_trouble();
}

void SessionWindow::write_moving_texts() {
  const double in_phase_s = seconds_between(shown_.phase_began_ns, now_ns());
  set_if_new(*now_, facts_ == nullptr && shown_.phase == SessionPhase::idle
                        ? tr("Preparing the session")
                        : SessionText::of_now(
                              shown_, trial_now(),
                              plan_->model().condition(shown_.trial, shown_.surface), in_phase_s));
  plan_->set_now(shown_.phase == SessionPhase::ended ? 0 : shown_.trial,
                 SessionText::of_phase(shown_, in_phase_s));
  const double elapsed_s = facts_ == nullptr ? 0.0 : seconds_between(shown_.began_ns, now_ns());
  set_if_new(*elapsed_, tr("%1 elapsed").arg(SessionText::of_duration(elapsed_s)));
}

void SessionWindow::write_pending() {
  const SessionRequests::Pending pending = requests_.pending();
  QStringList words{};
  if (is_running()) {
    if (shown_.phase == SessionPhase::paused) {
      words += pending.pause
                   ? tr("Paused since %1, Resume F5").arg(clock_text(shown_.phase_began_ns))
                   : tr("Going on");
    } else if (pending.pause) {
      words += tr("Pausing after this trial");
    }
    if (pending.stop == StopAfter::trial) words += tr("Stopping after this trial");
    if (pending.stop == StopAfter::block) words += tr("Stopping after this block");
    if (pending.repeat_last) words += tr("Repeating the last trial next");
    if (clearing_) words += tr("Clearing the fault");
  }
  const QString text = words.join(" · ");
  if (text == pending_->property("words").toString()) return;
  pending_->setProperty("words", text);
  if (text.isEmpty()) {
    pending_->clear();
  } else {
    pending_->set_state(State::look, text);
  }
}

void SessionWindow::write_controls() {
  const SessionRequests::Pending pending = requests_.pending();
  ControlState state{};
  state.running = is_running();
  state.paused = shown_.phase == SessionPhase::paused;
  state.pause_pending = pending.pause;
  state.stop_pending = pending.stop;
  state.repeat_pending = pending.repeat_last;
  state.trial_done = !shown_.attempts->empty();
  state.in_trial = shown_.phase == SessionPhase::fore || shown_.phase == SessionPhase::contact ||
                   shown_.phase == SessionPhase::response;
  state.in_fault = shown_.phase == SessionPhase::fault;
  state.note_locked = notes_->is_locked();
  controls_->show_state(state);
}

void SessionWindow::write_answers() { answers_->show_answers(*shown_.attempts, plan_->model()); }

void SessionWindow::write_health() { health_->show_health(shown_, facts_.get()); }

QString SessionWindow::veiled(const std::string& text) const {
  const QString words = QString::fromStdString(text);
  return blind_ ? veil_.veiled(words) : words;
}

QString SessionWindow::fault_text() const {
  const SessionSnapshot& s = shown_;
  if (!stopped_at_.isEmpty() || s.fault == Fault::emergency_stop) {
    const QString when = stopped_at_.isEmpty() ? clock_text(s.phase_began_ns) : stopped_at_;
    if (!stop_is_confirmed_) {
      return tr("EMERGENCY STOP at %1. Zero force was asked of the device; its answer is awaited.")
          .arg(when);
    }
    if (s.trouble) return tr("EMERGENCY STOP at %1. %2").arg(when, veiled(s.trouble->what));
    return tr("EMERGENCY STOP at %1. The force is zero and is held there.").arg(when);
  }
  if (s.trouble) {
    return tr("Stopped at %1, the force is held at zero. %2")
        .arg(clock_text(s.trouble->time_ns), veiled(s.trouble->what));
  }
  return tr("Stopped at %1, the force is held at zero: %2.")
      .arg(clock_text(s.phase_began_ns), OutcomeWords::of_fault(s.fault));
}

void SessionWindow::write_trouble() {
  const SessionSnapshot& s = shown_;
  // To clear something is always asked in the same way, with the question whether it is safe.
  const bool to_clear = s.trouble && s.trouble->remedy == SessionTrouble::Remedy::clear_fault;
  const bool in_fault = s.phase == SessionPhase::fault || s.fault != Fault::none || to_clear;
  if (stop_is_confirmed_ && !in_fault) stopped_at_.clear();  // it is over
  stop_is_confirmed_ = in_fault;
  if ((in_fault || !stopped_at_.isEmpty()) && !ended_ && !clearing_) {
    const bool can_clear = !s.trouble || to_clear || s.fault == Fault::emergency_stop;
    fault_->show_fault(fault_text(), can_clear);
    trouble_->hide();
    trouble_shown_.reset();
    return;
  }
  if (ended_ || clearing_ || !in_fault) fault_->hide();
  const bool same = s.trouble.has_value() == trouble_shown_.has_value() &&
                    (!s.trouble || (s.trouble->what == trouble_shown_->what &&
                                    s.trouble->time_ns == trouble_shown_->time_ns));
  if (same && !(ended_ && trouble_->isVisible())) return;
  trouble_shown_ = s.trouble;
  if (!s.trouble || ended_ || clearing_) return trouble_->hide();
  const QString what = tr("%1  %2").arg(clock_text(s.trouble->time_ns), veiled(s.trouble->what));
  switch (s.trouble->remedy) {
    case SessionTrouble::Remedy::none:
    case SessionTrouble::Remedy::try_again:
    case SessionTrouble::Remedy::clear_fault:
      trouble_->show_news(State::look, what);
      break;
    case SessionTrouble::Remedy::confirm:
      trouble_->show_news(State::look, what, tr("Done (F5)"), [this] { requests_.confirm(); });
      break;
    case SessionTrouble::Remedy::resume:
      trouble_->show_news(State::look, what, tr("Resume"), [this] { requests_.resume(); });
      break;
  }
}

// --- the end -------------------------------------------------------------------------------------

void SessionWindow::end() {
  ended_ = true;
  keys_->switch_off();
  stopped_at_.clear();
  reason_->hide();
  if (dialog_ != nullptr) dialog_->close();
  notes_->lock(field_lock());
  write_controls();
  write_pending();
  write_health();
  write_trouble();
  const bool complete =
      end_ ? end_->state == SessionState::completed
           : shown_.trials > 0 && shown_.trials_done >= shown_.trials && !shown_.trouble;
  QString why{};
  if (end_ && !end_->reason.empty()) {
    why = QString::fromStdString(end_->reason);
  } else if (shown_.trouble) {
    why = QString::fromStdString(shown_.trouble->what);
  }
  if (!why.isEmpty()) {
    if (blind_) why = veil_.veiled(why);
    why = tr("What ended it: %1").arg(why);
  }
  summary_->show_end(shown_, facts_ == nullptr ? SessionRow{} : facts_->row, complete, why);
  pages_->setCurrentWidget(summary_);
  controls_->hide();
  left_->hide();
  if (close_when_ended_) close();
}

void SessionWindow::show_end(const SessionEnd& how) {
  end_ = how;
  shown_ = monitor_.snapshot();
  end();
}

void SessionWindow::show_failure(const QString& what) {
  failed_ = true;
  keys_->switch_off();
  if (dialog_ != nullptr) dialog_->close();
  news_->show_news(State::stop, blind_ ? veil_.veiled(what) : what, tr("Close"),
                   [this] { close(); });
  write_controls();
}

bool SessionWindow::may_close() {
  if (!is_running()) return true;
  ask_close();
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
    pending_->setProperty("words", {});
    if (facts_ != nullptr) band_->set_mode(facts_->row.mode);
    write_blindness();
    write_pending();
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

void SessionWindow::tell_screen_lost(const QString& name) {
  news_->show_news(State::look,
                   tr("The participant's screen “%1” is gone. The session pauses after "
                      "this trial; their window stands on the screen that is left.")
                       .arg(name));
}

void SessionWindow::screen_left(QScreen* screen) {
  const QString name = screen == nullptr ? QString() : screen->name();
  news_->show_news(State::look,
                   tr("The screen “%1” was unplugged. What was on it is now on another one. Pause, "
                      "and plug it in again, if it was the participant's.")
                       .arg(name),
                   tr("Pause"), [this] { do_verb(SessionVerb::pause); });
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
