// Implements an event filter of the application that maps key presses of both windows to session verbs.

#include "app/gui/base/session_keys.h"

#include <optional>

#include <QtCore/QCoreApplication>
#include <QtGui/QKeyEvent>
#include <QtWidgets/QApplication>

namespace asperity {

namespace {

// The keypad and the state of Num Lock say nothing about what a key means.
Qt::KeyboardModifiers modifiers_of(const QKeyEvent& key) {
  return key.modifiers() &
         (Qt::ControlModifier | Qt::ShiftModifier | Qt::AltModifier | Qt::MetaModifier);
}

std::optional<SessionVerb> verb_of(const QKeyEvent& key) {
  const bool dialog_is_open =
      QApplication::activeModalWidget() != nullptr || QApplication::activePopupWidget() != nullptr;
  const auto unless_dialog = [dialog_is_open](SessionVerb verb) {
    return dialog_is_open ? std::nullopt : std::optional(verb);
  };
  const Qt::KeyboardModifiers modifiers = modifiers_of(key);
  if (modifiers == Qt::NoModifier) {
    switch (key.key()) {
      case Qt::Key_F5:
        return SessionVerb::start_or_resume;
      case Qt::Key_Escape:
        return unless_dialog(SessionVerb::leave_or_pause);
      case Qt::Key_F6:
        return SessionVerb::pause;
      case Qt::Key_F7:
        return SessionVerb::stop_after_trial;
      case Qt::Key_F8:
        return SessionVerb::stop_after_block;
      case Qt::Key_F9:
        return SessionVerb::show_participant;
      case Qt::Key_F2:
        return unless_dialog(SessionVerb::note);
      default:
        return std::nullopt;
    }
  }
  if (modifiers == Qt::ControlModifier && key.key() == Qt::Key_R) {
    return unless_dialog(SessionVerb::repeat_last);
  }
  if (modifiers == (Qt::ControlModifier | Qt::ShiftModifier) && key.key() == Qt::Key_Q) {
    return unless_dialog(SessionVerb::abort);
  }
  return std::nullopt;
}

}  // namespace

bool is_emergency(const QKeyEvent& key) {
  return key.key() == Qt::Key_F12 || key.key() == Qt::Key_Pause ||
         (key.key() == Qt::Key_Space && modifiers_of(key) == Qt::ControlModifier);
}

SessionKeys::SessionKeys(QObject* parent) : QObject(parent) {
  QCoreApplication::instance()->installEventFilter(this);
}

bool SessionKeys::eventFilter(QObject* watched, QEvent* event) {
  const bool press = event->type() == QEvent::KeyPress;
  if (!is_on_ || (!press && event->type() != QEvent::ShortcutOverride)) {
    return QObject::eventFilter(watched, event);
  }
  const auto& key = static_cast<const QKeyEvent&>(*event);
  const bool emergency_key = is_emergency(key);
  const std::optional<SessionVerb> verb = emergency_key ? std::nullopt : verb_of(key);
  if (!emergency_key && !verb) return QObject::eventFilter(watched, event);
  // An override that is accepted keeps shortcuts away: the press comes here next.
  event->accept();
  if (press && !key.isAutoRepeat()) {
    if (emergency_key) {
      emit emergency();
    } else {
      emit wanted(*verb);
    }
  }
  return true;
}

}  // namespace asperity

#include "moc_session_keys.cpp"
