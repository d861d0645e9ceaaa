// Updates the parts from the monitor at each frame, and turns keys and buttons into requests.

#include "app/gui/session/session_window.h"

#include <utility>

#include <QtCore/QTime>
#include <QtCore/QTimer>
#include <QtGui/QCloseEvent>
#include <QtGui/QGuiApplication>
#include <QtGui/QScreen>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QStackedWidget>

#include "app/gui/look/controls.h"
#include "app/gui/look/words.h"
#include "app/gui/session/answers_panel.h"
#include "app/gui/session/end_summary.h"
#include "app/gui/session/health_line.h"
#include "app/gui/session/live_plots.h"
#include "app/gui/session/mirror_frame.h"
#include "app/gui/session/notes_panel.h"
#include "app/gui/session/plan_table.h"
#include "app/gui/session/reason_form.h"
#include "app/gui/session/session_controls.h"
#include "app/gui/session/session_header.h"
#include "app/gui/session/session_parts.h"
#include "app/gui/session/session_questions.h"
#include "app/gui/session/session_troubles.h"
#include "app/gui/session/track_panel.h"
#include "app/gui/session/window_place.h"
#include "app/words/offered_reasons.h"
#include "app/words/reason.h"

namespace asperity {

namespace {

// A little faster than 60 Hz, so that no bin waits for two frames.
constexpr int kSessionFrame_ms = 16;
// What the narrowest form needs in German.
constexpr QSize kSmallest{672, 560};

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
  connect(controls_, &SessionControls::skip_wanted, this, [this] {
    if (only_tried_) {
      requests_.skip(phrase_of(Reason::stopped_as_asked));
    } else {
      questions_->ask_to_skip(shown_.trial);
    }
  });
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
  tracks_ = new TrackPanel(pages_);
  answers_ = new AnswersPanel(pages_);
  notes_ = new NotesPanel(pages_);
  mirror_ = new MirrorFrame(pages_);
  parts_ = new SessionParts({.plan = plan_,
                             .plots = plots_,
                             .tracks = tracks_,
                             .sight = mirror_,
                             .answers = answers_,
                             .notes = notes_},
                            pages_);
  pages_->addWidget(parts_);
}

void SessionWindow::set_mirror(QWidget* mirror) { mirror_->set_mirror(mirror); }

void SessionWindow::set_only_tried(bool only_tried) {
  only_tried_ = only_tried;
  write_controls();
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
  refresh();  // it may have begun since the last frame
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
      if (shown_.purpose == AttemptPurpose::refresher) break;
      if (only_tried_) {
        requests_.repeat_last(phrase_of(Reason::stopped_as_asked));
        break;
      }
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
      if (only_tried_) {
        requests_.abort(phrase_of(Reason::stopped_as_asked));
      } else {
        questions_->ask_to_abort();
      }
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
  tracks_->set_blind(blind_);
  troubles_->set_blind(blind_);
  write_answers();
  write_tracks();
  if (ended_) write_end();
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
  // Responses show conditions, and whether they were correct, to the experimenter who resumes the session.
  if (end_ && !(outcome.can_go_on && blind_)) {
    for (const Phrase& anchors : end_->anchors) {
      outcome.anchors += troubles_->veiled(words_of(anchors));
    }
  }
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
  if (only_tried_) {
    do_verb(SessionVerb::abort);
    close_when_ended_ = true;
  } else {
    questions_->ask_to_leave();
  }
  return ended_;  // meanwhile
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
