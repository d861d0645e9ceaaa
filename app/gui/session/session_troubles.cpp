// What went wrong in a session, and the button that helps.

#include "app/gui/session/session_troubles.h"

#include <utility>

#include <QtCore/QTime>
#include <QtWidgets/QBoxLayout>

#include "app/gui/look/controls.h"
#include "app/gui/look/outcome_words.h"
#include "app/gui/look/words.h"
#include "app/gui/session/fault_panel.h"
#include "app/gui/session/session_clock.h"

namespace asperity {

namespace {

// A fault that is still there after this was not cleared.
constexpr int kClearing_ms = 3000;

}  // namespace

SessionTroubles::SessionTroubles(SessionRequests& requests, QVBoxLayout& rows, QWidget* parent)
    : QObject(parent), requests_(requests) {
  fault_ = new FaultPanel(parent);
  trouble_ = new Banner(parent);
  trouble_->setObjectName("trouble");
  device_ = new Banner(parent);
  device_->setObjectName("device_trouble");
  news_ = new Banner(parent);
  news_->setObjectName("news");
  rows.addWidget(fault_);
  rows.addWidget(trouble_);
  rows.addWidget(device_);
  rows.addWidget(news_);
  connect(fault_, &FaultPanel::clear_wanted, this, &SessionTroubles::clear_fault);
  connect(fault_, &FaultPanel::end_wanted, this, &SessionTroubles::end_wanted);
}

void SessionTroubles::set_facts(std::shared_ptr<const SessionFacts> facts) {
  facts_ = std::move(facts);
  if (facts_ != nullptr && facts_->protocol != nullptr && facts_->plan != nullptr) {
    veil_ = NameVeil(*facts_->protocol, *facts_->plan);
  }
  if (facts_ != nullptr && std::exchange(is_told_, false)) news_->hide();  // the device is there
}

void SessionTroubles::set_blind(bool blind) {
  blind_ = blind;
  trouble_shown_.reset();
  write();
}

QString SessionTroubles::veiled(const QString& text) const {
  return blind_ ? veil_.veiled(text) : text;
}

QString SessionTroubles::clock_text(std::int64_t time_ns) const {
  return text_of_clock(time_ns, shown_, facts_.get());
}

// --- a fault -------------------------------------------------------------------------------------

void SessionTroubles::show_emergency() {
  if (ended_) return;
  stopped_at_ = QTime::currentTime().toString("HH:mm:ss");
  clearing_ = false;
  write();
}

void SessionTroubles::clear_fault() {
  requests_.clear_fault();
  stopped_at_.clear();
  clearing_ = true;
  cleared_trouble_ns_ = shown_.trouble ? shown_.trouble->time_ns : 0;
  since_clearing_.start();
  fault_->hide();
}

void SessionTroubles::look_again() {
  if (!clearing_ || since_clearing_.elapsed() <= kClearing_ms) return;
  clearing_ = false;
  write();
}

QString SessionTroubles::fault_text() const {
  const SessionSnapshot& s = shown_;
  const QString what = s.trouble ? veiled(words_of(s.trouble->what)) : QString();
  if (!stopped_at_.isEmpty() || s.fault == Fault::emergency_stop) {
    const QString when = stopped_at_.isEmpty() ? clock_text(s.phase_began_ns) : stopped_at_;
    if (!stop_is_confirmed_) {
      return tr("EMERGENCY STOP at %1. The device was commanded to zero force; its response is "
                "awaited.")
          .arg(when);
    }
    if (s.trouble) return tr("EMERGENCY STOP at %1. %2").arg(when, what);
    return tr("EMERGENCY STOP at %1. The force is zero and is held at zero.").arg(when);
  }
  if (s.trouble) {
    return tr("Stopped at %1; the force is held at zero. %2")
        .arg(clock_text(s.trouble->time_ns), what);
  }
  return tr("Stopped at %1; the force is held at zero: %2.")
      .arg(clock_text(s.phase_began_ns), OutcomeWords::of_fault(s.fault));
}

// --- what the session reports --------------------------------------------------------------------

void SessionTroubles::show_snapshot(const SessionSnapshot& snapshot) {
  shown_ = snapshot;
  const bool is_cleared = shown_.phase != SessionPhase::fault && shown_.fault == Fault::none;
  const bool has_failed = shown_.trouble && shown_.trouble->time_ns != cleared_trouble_ns_;
  if (clearing_ && (is_cleared || has_failed)) clearing_ = false;
  write();
}

void SessionTroubles::end() {
  ended_ = true;
  stopped_at_.clear();
  write();
}

void SessionTroubles::write_device() {
  const std::string complaint = ended_ ? std::string() : shown_.device_complaint;
  // One that was put away comes back when it says something else.
  if (complaint == device_shown_) return;
  device_shown_ = complaint;
  if (complaint.empty()) return device_->hide();
  device_->show_news(State::look, tr("%1  The device reports: %2")
                                      .arg(clock_text(shown_.device_complains_since_ns),
                                           QString::fromStdString(complaint)));
}

void SessionTroubles::write() {
  write_device();
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
  const QString what =
      tr("%1  %2").arg(clock_text(s.trouble->time_ns), veiled(words_of(s.trouble->what)));
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

// --- news of the windows -------------------------------------------------------------------------

void SessionTroubles::show_told(const QString& sentence) {
  is_told_ = true;
  news_->show_news(State::look, sentence);
}

void SessionTroubles::show_failure(const QString& what, AfterFailure next) {
  is_told_ = false;
  news_->show_news(State::stop, veiled(what), SessionText::of_way_on(next),
                   [this, next] { emit way_on_wanted(next); });
}

void SessionTroubles::show_screen_removed(const QString& name) {
  news_->show_news(State::look,
                   tr("The screen “%1” was disconnected. Its contents are now on another screen. "
                      "If it was the participant's screen, pause and reconnect it.")
                       .arg(name),
                   tr("Pause"), [this] { emit pause_wanted(); });
}

void SessionTroubles::show_participant_screen_lost(const QString& name, ScreenLoss loss) {
  QString text{};
  switch (loss) {
    case ScreenLoss::force_stopped:
      text = tr("The participant's screen “%1” was disconnected: the force is zero, and the trial "
                "is repeated. Reconnect the screen, restore the window, then clear the stop.")
                 .arg(name);
      break;
    case ScreenLoss::pausing:
      text = tr("The participant's screen “%1” was disconnected. There is no force, and the "
                "session pauses before the next trial. Reconnect the screen, restore the "
                "participant's window, then resume with F5.")
                 .arg(name);
      break;
    case ScreenLoss::still_gone:
      text = tr("The screen “%1” is still disconnected. Until it is reconnected, the participant's "
                "window is shown on the remaining screen.")
                 .arg(name);
      break;
  }
  news_->show_news(State::look, text, tr("Restore window"),
                   [this, name] { emit participant_screen_back(name); });
}

}  // namespace asperity

#include "moc_session_troubles.cpp"
