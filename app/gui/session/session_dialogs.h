// The two questions of a session that have to be answered: abort it, or leave it.

#pragma once

#include <functional>

#include <QtWidgets/QDialog>

#include "analysis/words/phrase.h"

namespace asperity {

class ReasonForm;

/// Names what an abort loses, and asks why. Gone when it is answered.
///
/// Shown, not opened: a modal dialog would block its window, and with it the emergency stop.
class AbortDialog final : public QDialog {
  Q_OBJECT
 public:
  AbortDialog(QWidget* parent, std::function<void(Phrase)> on_abort);
  /// Why nothing can be typed now; empty: it can.
  void lock(const QString& why);

 private:
  ReasonForm* form_ = nullptr;
};

enum class Leaving { stop_after_trial, abort_now };

/// What to do with a session that runs when its window is closed. Keeping it running is what Esc and
/// Return do.
class CloseDialog final : public QDialog {
  Q_OBJECT
 public:
  CloseDialog(QWidget* parent, std::function<void(Leaving)> on_leave);
};

}  // namespace asperity
