// Filters the key events of the application, and greys the experimenter's fields during a response.

#include "app/gui/participant/response_keys.h"

#include <QtGui/QInputMethodEvent>
#include <QtGui/QKeyEvent>
#include <QtGui/QKeySequence>
#include <QtWidgets/QAbstractSpinBox>
#include <QtWidgets/QApplication>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPlainTextEdit>
#include <QtWidgets/QStyle>
#include <QtWidgets/QTextEdit>
#include <QtWidgets/QToolTip>
#include <QtWidgets/QWidget>

#include "app/gui/participant/participant_keys.h"
#include "app/gui/participant/participant_view.h"

namespace asperity {

namespace {

bool takes_text(const QWidget* widget) {
  return widget != nullptr && widget->isEnabled() &&
         widget->testAttribute(Qt::WA_InputMethodEnabled);
}

bool is_text_field(const QWidget& widget) {
  if (const auto* list = qobject_cast<const QComboBox*>(&widget)) return list->isEditable();
  return qobject_cast<const QLineEdit*>(&widget) != nullptr ||
         qobject_cast<const QTextEdit*>(&widget) != nullptr ||
         qobject_cast<const QPlainTextEdit*>(&widget) != nullptr ||
         qobject_cast<const QAbstractSpinBox*>(&widget) != nullptr;
}

/// A menu, the list of a choice, a dialog that does not hold up the others.
bool is_question(const QWidget& window) {
  return window.windowType() == Qt::Popup || window.windowType() == Qt::Dialog;
}

void set_waits(QWidget& field, bool waits) {
  field.setProperty("waits", waits);
  // As the theme draws it: its rules are chosen when a widget is polished.
  field.style()->unpolish(&field);
  field.style()->polish(&field);
  field.update();
}

}  // namespace

ResponseKeys::ResponseKeys(ParticipantView& view, QObject* parent)
    : QObject(parent),
      view_(view),
      had_desktop_dialogs_(!QCoreApplication::testAttribute(Qt::AA_DontUseNativeDialogs)) {
  QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
  qApp->installEventFilter(this);
  connect(&view_, &ParticipantView::scene_changed, this, &ResponseKeys::grey_fields);
  connect(qApp, &QApplication::focusChanged, this,
          [this](QWidget*, QWidget* now) { focus_moved(now); });
}

ResponseKeys::~ResponseKeys() {
  qApp->removeEventFilter(this);
  QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs, !had_desktop_dialogs_);
  for (const QPointer<QWidget>& field : greyed_) {
    if (field != nullptr) set_waits(*field, false);
  }
}

void ResponseKeys::set_own_keyboard(bool own) {
  own_keyboard_ = own;
  grey_fields();
}

void ResponseKeys::grey(QWidget& field) {
  if (!is_text_field(field) || field.window() == view_.window()) return;
  set_waits(field, true);
  greyed_.emplace_back(&field);
}

void ResponseKeys::grey_fields() {
  const bool open = view_.scene().response_open && !own_keyboard_;
  if (open != greyed_.empty()) return;
  if (!open) {
    for (const QPointer<QWidget>& field : greyed_) {
      if (field != nullptr) set_waits(*field, false);
    }
    greyed_.clear();
    return;
  }
  for (QWidget* top : QApplication::topLevelWidgets()) {
    if (!top->isVisible()) continue;
    for (QWidget* field : top->findChildren<QWidget*>()) {
      if (field->isVisible()) grey(*field);
    }
  }
}

bool ResponseKeys::belongs_to_participant(const QWidget& receiver) const {
  const QWidget* window = receiver.window();
  if (window == view_.window()) return true;
  if (own_keyboard_) return false;
  if (view_.scene().response_open) return true;
  if (QApplication::activeModalWidget() != nullptr || is_question(*window)) return false;
  // A field that has no use for a key passes it on to its parents: they are not asked, the field is.
  return view_.waits() && !takes_text(&receiver) && !takes_text(window->focusWidget());
}

bool ResponseKeys::is_stray(const QWidget& receiver, const QKeyEvent& event) const {
  const QWidget* window = receiver.window();
  const bool confirms = event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
  return confirms && window != view_.window() && window != session_window_ &&
         view_.would_leave_out();
}

bool ResponseKeys::is_kept_from(const QWidget& receiver, const QKeyEvent& event) const {
  if (receiver.window() == view_.window() || !view_.scene().response_open) return false;
  if (is_command_key(event) || event.text().isEmpty()) return false;
  return event.text().front().isPrint() || event.key() == Qt::Key_Backspace ||
         event.key() == Qt::Key_Delete || event.key() == Qt::Key_Return ||
         event.key() == Qt::Key_Enter;
}

bool ResponseKeys::pressed(QKeyEvent& event) {
  if (event.isAutoRepeat() && !view_.repeats(event)) return true;
  const std::int64_t pressed_ns = view_.time_of_ns(event.timestamp());
  const QString typed = event.text();
  const QString name = typed.isEmpty() || !typed.front().isPrint() || typed == " "
                           ? QKeySequence(event.key()).toString(QKeySequence::PortableText)
                           : typed;
  if (!view_.press(event, pressed_ns)) return false;
  if (!event.isAutoRepeat()) held_[event.key()] = {.name = name, .pressed_ns = pressed_ns};
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

/// Beside the field, for as long as Qt shows such a thing.
void ResponseKeys::tell_why(QWidget& field) const {
  if (field.window() == view_.window()) return;
  QToolTip::showText(field.mapToGlobal(field.rect().bottomLeft()),
                     tr("Keys reserved for the response"), &field);
}

bool ResponseKeys::eventFilter(QObject* watched, QEvent* event) {
  if (!watched->isWidgetType()) return false;
  auto& receiver = static_cast<QWidget&>(*watched);
  switch (event->type()) {
    case QEvent::ShortcutOverride:
    case QEvent::KeyPress: {
      auto& key = static_cast<QKeyEvent&>(*event);
      if (!belongs_to_participant(receiver) || is_stray(receiver, key)) return false;
      // What is typed into the participant's own text field is typed there, not sent there.
      const bool typing = takes_text(&receiver) && receiver.window() == view_.window();
      const bool taken = (!typing && view_.has_use_for(key)) || is_kept_from(receiver, key);
      if (!taken) return false;
      if (event->type() == QEvent::KeyPress && view_.has_use_for(key)) pressed(key);
      if (event->type() == QEvent::KeyPress && is_text_field(receiver)) tell_why(receiver);
      event->accept();
      return true;
    }
    case QEvent::Show:
      // One that is opened meanwhile.
      if (view_.scene().response_open && !own_keyboard_) grey(static_cast<QWidget&>(*watched));
      return false;
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

#include "moc_response_keys.cpp"
