#include "app/gui/participant/response_keys.h"

#include <QtGui/QInputMethodEvent>
#include <QtGui/QKeyEvent>
#include <QtGui/QKeySequence>
#include <QtWidgets/QApplication>
#include <QtWidgets/QWidget>

#include "app/gui/participant/participant_view.h"

namespace asperity {

namespace {

bool takes_text(const QWidget* widget) {
  return widget != nullptr && widget->isEnabled() &&
         widget->testAttribute(Qt::WA_InputMethodEnabled);
}

bool is_command(const QKeyEvent& event) {
  return (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) != 0;
}

}  // namespace

ResponseKeys::ResponseKeys(ParticipantView& view, QObject* parent) : QObject(parent), view_(view) {
  qApp->installEventFilter(this);
  connect(qApp, &QApplication::focusChanged, this,
          [this](QWidget*, QWidget* now) { focus_moved(now); });
}

ResponseKeys::~ResponseKeys() { qApp->removeEventFilter(this); }

bool ResponseKeys::belongs_to_participant(const QWidget& receiver) const {
  const QWidget* window = receiver.window();
  if (window == view_.window()) return true;
  if (own_keyboard_ || QApplication::activeModalWidget() != nullptr) return false;
  if (view_.scene().response_open) return true;
  // A field that has no use for a key passes it on to its parents: they are not asked, the field is.
  return view_.waits() && !takes_text(&receiver) && !takes_text(window->focusWidget());
}

bool ResponseKeys::is_kept_from(const QWidget& receiver, const QKeyEvent& event) const {
  if (receiver.window() == view_.window() || !view_.scene().response_open) return false;
  if (is_command(event) || event.text().isEmpty()) return false;
  return event.text().front().isPrint() || event.key() == Qt::Key_Backspace ||
         event.key() == Qt::Key_Delete || event.key() == Qt::Key_Return ||
         event.key() == Qt::Key_Enter;
}

bool ResponseKeys::pressed(QKeyEvent& event) {
  if (event.isAutoRepeat()) return true;
  const std::int64_t pressed_ns = view_.time_of_ns(event.timestamp());
  const QString typed = event.text();
  const QString name = typed.isEmpty() || !typed.front().isPrint() || typed == " "
                           ? QKeySequence(event.key()).toString(QKeySequence::PortableText)
                           : typed;
  if (!view_.press(event, pressed_ns)) return false;
  held_[event.key()] = {.name = name, .pressed_ns = pressed_ns};
  return true;
}

bool ResponseKeys::released(const QKeyEvent& event) {
  const auto held = held_.find(event.key());
  if (held == held_.end()) return false;
  if (event.isAutoRepeat()) return true;
  const double held_s =
      static_cast<double>(view_.time_of_ns(event.timestamp()) - held->second.pressed_ns) * 1e-9;
  view_.release(held->second.name, held->second.pressed_ns, held_s);
  held_.erase(held);
  return true;
}

bool ResponseKeys::eventFilter(QObject* watched, QEvent* event) {
  if (!watched->isWidgetType()) return false;
  const auto& receiver = static_cast<const QWidget&>(*watched);
  switch (event->type()) {
    case QEvent::ShortcutOverride:
    case QEvent::KeyPress: {
      auto& key = static_cast<QKeyEvent&>(*event);
      if (!belongs_to_participant(receiver)) return false;
      // What is typed into the participant's own text field is typed there, not sent there.
      const bool typing = takes_text(&receiver) && receiver.window() == view_.window();
      const bool taken = (!typing && view_.has_use_for(key)) || is_kept_from(receiver, key);
      if (!taken) return false;
      if (event->type() == QEvent::KeyPress && view_.has_use_for(key)) pressed(key);
      event->accept();
      return true;
    }
    case QEvent::KeyRelease:
      return released(static_cast<const QKeyEvent&>(*event));
    case QEvent::InputMethod: {
      // An input method writes past the keys: what it would write into a note is a key pressed.
      const auto& written = static_cast<const QInputMethodEvent&>(*event);
      const bool open = view_.scene().response_open && receiver.window() != view_.window();
      if (!open || !belongs_to_participant(receiver)) return false;
      const QString text = written.commitString();
      if (text.size() == 1) {
        QKeyEvent key(QEvent::KeyPress, text.front().toUpper().unicode(), Qt::NoModifier, text);
        view_.press(key, view_.time_of_ns(0));
      }
      event->accept();
      return true;
    }
    case QEvent::MouseMove:
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonRelease:
      // Every stamp tells how far the window system's clock is from ours. The view's own events are
      // heard by itself.
      if (watched != &view_) view_.time_of_ns(static_cast<QInputEvent&>(*event).timestamp());
      return false;
    default:
      return false;
  }
}

void ResponseKeys::focus_moved(const QWidget* now) {
  QString who = "another program";
  if (now != nullptr) {
    if (now->window() == view_.window()) {
      who = "participant";
    } else {
      who = takes_text(now) ? "experimenter, text field" : "experimenter";
    }
  }
  if (who == focus_) return;
  focus_ = who;
  emit remarked("focus_changed", who);
}

}  // namespace asperity
