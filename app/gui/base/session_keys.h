// The experimenter's keys, whichever window of the program has the focus.

#pragma once

#include <QtCore/QObject>

class QKeyEvent;

namespace asperity {

/// What the experimenter can ask for by a key.
enum class SessionVerb {
  start_or_resume,   ///< F5
  pause,             ///< F6
  leave_or_pause,    ///< Esc: takes the question away that stands in the window, or else pauses
  stop_after_trial,  ///< F7
  stop_after_block,  ///< F8
  repeat_last,       ///< Ctrl+R
  note,              ///< F2
  abort,             ///< Ctrl+Shift+Q
  show_participant,  ///< F9: their window comes back to its place, in front
};

/// F12, Pause/Break and Ctrl+Space, wherever a device may be pushing: no force, now.
bool is_emergency(const QKeyEvent& key);

/// An event filter of the application rather than shortcuts: a shortcut sleeps while a dialog is
/// open, and the emergency stop must not.
///
/// The emergency stop is F12 (written on the button: it is there on every laptop and needs no second
/// key); Pause/Break and Ctrl+Space do the same. While a modal dialog of another window is open, Esc
/// belongs to it and the verbs that open something are left alone; all others work on.
class SessionKeys final : public QObject {
  Q_OBJECT
 public:
  explicit SessionKeys(QObject* parent);
  /// No key means anything once the session has ended.
  void switch_off() { is_on_ = false; }

 signals:
  /// At the press itself.
  void emergency();
  void wanted(asperity::SessionVerb verb);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool is_on_ = true;
};

}  // namespace asperity
