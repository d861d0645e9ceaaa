// Opens the form or dialog for each question, and passes the reason to the requests of the session.

#include "app/gui/session/session_questions.h"

#include <utility>

#include "app/gui/session/reason_form.h"
#include "app/gui/session/session_dialogs.h"
#include "app/words/offered_reasons.h"
#include "app/words/reason.h"

namespace asperity {

SessionQuestions::SessionQuestions(SessionRequests& requests, ReasonForm& form, QWidget& window)
    : QObject(&window), requests_(requests), form_(form), window_(window) {}

void SessionQuestions::lock(const QString& why) {
  why_locked_ = why;
  form_.lock(why);
  if (auto* abort = qobject_cast<AbortDialog*>(dialog_.data())) abort->lock(why);
}

void SessionQuestions::ask_to_repeat() {
  form_.ask(
      tr("Reason for repeating the last trial. Its response remains stored but no longer counts."),
      offered_reasons(ReasonFor::repeating), tr("Repeat last trial"),
      [this](const Phrase& reason) { requests_.repeat_last(reason); });
}

void SessionQuestions::ask_to_skip(int trial) {
  form_.ask(tr("Reason for skipping trial %1. It is stored as skipped and not presented again.")
                .arg(trial),
            offered_reasons(ReasonFor::skipping), tr("Skip this trial"),
            [this](const Phrase& reason) { requests_.skip(reason); });
}

void SessionQuestions::ask_to_unblind(std::function<void(Phrase)> on_reason) {
  form_.ask(
      tr("Reason for unblinding. It is stored with the session, and the window stays marked."),
      offered_reasons(ReasonFor::unblinding), tr("Unblind"), std::move(on_reason));
}

void SessionQuestions::ask_to_abort() {
  if (dialog_ != nullptr && dialog_->isVisible()) return dialog_->raise();
  auto* dialog =
      new AbortDialog(&window_, [this](const Phrase& reason) { requests_.abort(reason); });
  dialog->lock(why_locked_);
  dialog_ = dialog;
  dialog_->show();
}

void SessionQuestions::ask_to_leave() {
  if (dialog_ != nullptr && dialog_->isVisible()) return dialog_->raise();
  dialog_ = new CloseDialog(&window_, [this](Leaving how) {
    if (how == Leaving::abort_now) {
      requests_.abort(phrase_of(Reason::session_window_closed));
    } else {
      requests_.stop_after(StopAfter::trial);
      // A pause would keep it from ever coming to that.
      requests_.resume();
    }
    emit leaving();
  });
  dialog_->show();
}

bool SessionQuestions::take_back_one() {
  if (dialog_ != nullptr && dialog_->isVisible()) {
    dialog_->reject();
    return true;
  }
  if (!form_.isVisible()) return false;
  form_.cancel();
  return true;
}

void SessionQuestions::take_all_back() {
  if (dialog_ != nullptr) dialog_->reject();
  form_.cancel();
}

void SessionQuestions::end() {
  form_.hide();
  if (dialog_ != nullptr) dialog_->close();
}

}  // namespace asperity

#include "moc_session_questions.cpp"
