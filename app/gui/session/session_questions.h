// What the experimenter is asked before something is done that a reason has to stand beside.

#pragma once

#include <functional>

#include <QtCore/QObject>
#include <QtCore/QPointer>
#include <QtWidgets/QDialog>

#include "app/session/session_requests.h"

namespace asperity {

class ReasonForm;

/// One question at a time in the window's form, and the two that end a session as dialogs: shown,
/// never modal, so that the emergency stop can be clicked and heard.
class SessionQuestions final : public QObject {
  Q_OBJECT
 public:
  /// `form` is in the window.
  SessionQuestions(SessionRequests& requests, ReasonForm& form, QWidget& window);

  /// Why nothing can be typed now; empty: it can.
  void lock(const QString& why);
  void ask_to_repeat();
  void ask_to_skip(int trial);
  void ask_to_abort();
  void ask_to_leave();
  void ask_to_unblind(std::function<void(Phrase)> on_reason);
  /// Takes back what is asked, the dialog before the form; false when nothing is.
  bool take_back_one();
  void take_all_back();
  /// Nothing of it means anything any more.
  void end();

 signals:
  /// The session is to end so that its window can close; it has been asked to.
  void leaving();

 private:
  SessionRequests& requests_;
  ReasonForm& form_;
  QWidget& window_;
  QString why_locked_{};
  QPointer<QDialog> dialog_{};
};

}  // namespace asperity
