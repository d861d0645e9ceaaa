// Brings the participant's keys to the trial, whichever window has the focus.

#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include <QtCore/QObject>
#include <QtCore/QPointer>
#include <QtCore/QString>
#include <QtWidgets/QWidget>

class QKeyEvent;

namespace asperity {

class ParticipantView;

/// One keyboard, two windows: while a response is open, what the scene has a use for (digits and
/// letters of the options, Space, Return) is taken from whichever of the application's windows has
/// the focus, and no text field gets it or any other sign that is typed.
///
/// Whose a key is, the first that holds:
///   - the participant's window has the focus: the participant's;
///   - a response is open: the participant's, whatever else is open. A question to the experimenter (a
///     dialog of any window, a menu) is then answered by mouse or left by Esc, and what it wants to
///     have typed is typed at the next interval: a trial's clock runs, the experimenter's does not;
///   - a question to the experimenter is open (a modal window, or the key goes to a dialog, a menu, the
///     list of a choice): the experimenter's;
///   - a text field has the focus: the experimenter's;
///   - another scene waits for the participant: theirs. What would leave a question out with nothing
///     answered is an exception: only the window of the session gives that (`set_session_window`), as
///     the Return of somebody who works in another one is not meant for it;
///   - otherwise the experimenter's.
/// With a keyboard of their own (`set_own_keyboard`) or device buttons only the first holds. Function
/// keys, Esc, Pause, Tab, arrows and whatever is pressed with Ctrl, Alt or Meta always pass; arrows and
/// Page up and down turn pages where a scene has some. Mouse buttons that are held, here or there,
/// change nothing of that.
///
/// While a response is open, text fields of all other windows are grey (their property "waits", which
/// the theme draws), and say why when somebody types into them.
///
/// Dialogs of the desktop would get keys past the program: while an object of this class lives, Qt's
/// own stand in for them.
///
/// One key is one answer: auto-repeat is ignored. A press is stamped and acted on at once; how long it
/// was held follows as an input of its own (ParticipantInput::Kind::released), but for what is typed
/// into a form.
class ResponseKeys final : public QObject {
  Q_OBJECT
 public:
  /// Filters the events of the application while it lives. `view` must outlive it.
  explicit ResponseKeys(ParticipantView& view, QObject* parent = nullptr);
  ~ResponseKeys() override;

  /// The experimenter's, of the session under way.
  void set_session_window(const QWidget* window) { session_window_ = window; }
  /// The participant answers by other means than the experimenter's keyboard.
  void set_own_keyboard(bool own);
  bool own_keyboard() const noexcept { return own_keyboard_; }

 signals:
  /// For the session's record: "focus_changed" with who has the keyboard now ("participant",
  /// "experimenter", "experimenter, text field", "another program").
  void remarked(const QString& kind, const QString& text);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Held {
    QString name{};
    std::int64_t pressed_ns = 0;
  };
  bool belongs_to_participant(const QWidget& receiver) const;
  /// Of a question that would be left out by it, from a window that has nothing to do with it.
  bool is_stray(const QWidget& receiver, const QKeyEvent& event) const;
  /// What is typed by mistake while a response is open ends nowhere.
  bool is_kept_from(const QWidget& receiver, const QKeyEvent& event) const;
  void tell_why(QWidget& field) const;
  bool pressed(QKeyEvent& event);
  bool released(const QKeyEvent& event);
  void focus_moved(const QWidget* now);
  /// Grey while a response is open; `field` alone, or all that are seen.
  void grey(QWidget& field);
  void grey_fields();

  ParticipantView& view_;
  QPointer<const QWidget> session_window_{};
  bool own_keyboard_ = false;
  std::map<int, Held> held_{};
  QString focus_{};
  bool had_desktop_dialogs_ = true;
  std::vector<QPointer<QWidget>> greyed_{};
};

}  // namespace asperity
