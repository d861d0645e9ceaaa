// What the participant does: the pointer and the keys.

#include <utility>

#include <QtGui/QKeyEvent>
#include <QtGui/QMouseEvent>
#include <QtWidgets/QApplication>
#include <QtWidgets/QPlainTextEdit>

#include "app/gui/participant/pages/page_for.h"
#include "app/gui/participant/participant_keys.h"
#include "app/gui/participant/participant_view.h"
#include "renderers/servo/servo_thread.h"

namespace asperity {

namespace {

using Action = ParticipantAction;
using Item = ParticipantItem;
using Scene = ParticipantScene;

constexpr std::int64_t kTwoDigits_ns = 1'000'000'000;  // between the digits of one key

}  // namespace

std::optional<std::size_t> ParticipantView::item_at(QPointF page_point) const {
  for (std::size_t i = 0; i < items_.size(); ++i) {
    if (items_[i].action && items_[i].rect.contains(page_point)) return i;
  }
  return {};
}

void ParticipantView::mousePressEvent(QMouseEvent* event) {
  const std::int64_t time_ns = time_of_ns(event->timestamp());
  press_.reset();
  if (event->button() != Qt::LeftButton) return;
  if (scene_->kind == Scene::Kind::blank && !scene_->surfaces.empty()) {
    if (!pointer_is_probe_) tell({.kind = ParticipantInput::Kind::click}, time_ns, "mouse");
    return;
  }
  const QPointF at = to_page(event->position());
  if (const std::optional<std::size_t> item = item_at(at)) {
    const Item& pressed = items_[*item];
    press_ = Press{.item = pressed, .at = at, .time_ns = time_ns};
    press_->letter = scene_page().carried_from(pressed);
    set_by_pointer(at, time_ns);
  }
}

void ParticipantView::mouseMoveEvent(QMouseEvent* event) {
  event_clock_.happened_ns(event->timestamp(), monotonic_now_ns());
  pointer_ = to_page(event->position());
  if (!press_) {
    setCursor(item_at(pointer_) ? Qt::PointingHandCursor : Qt::ArrowCursor);
    return;
  }
  set_by_pointer(pointer_, time_of_ns(event->timestamp()));
  if (!press_->letter.isEmpty() &&
      (pointer_ - press_->at).manhattanLength() >= QApplication::startDragDistance()) {
    press_->dragging = true;
    setCursor(Qt::ClosedHandCursor);
  }
  if (press_->dragging) update();
}

void ParticipantView::mouseReleaseEvent(QMouseEvent* event) {
  const std::int64_t released_ns = time_of_ns(event->timestamp());
  if (event->button() != Qt::LeftButton || !press_) return;
  const Press press = *press_;
  press_.reset();
  setCursor(Qt::ArrowCursor);
  update();
  const std::optional<std::size_t> item = item_at(to_page(event->position()));
  if (press.dragging) {
    auto input = scene_page().dropped(*scene_, press.item, item ? &items_[*item] : nullptr);
    if (input) tell(*std::move(input), released_ns, "mouse");
  } else if (press.set) {
    // It has been told.
  } else if (item && items_[*item].action == press.item.action) {
    act(Action(*press.item.action), press.time_ns, "mouse");
  } else {
    return;
  }
  if (keys_are_private()) return;
  tell({.kind = ParticipantInput::Kind::released,
        .text = "mouse button",
        .held_s = static_cast<double>(released_ns - press.time_ns) * 1e-9},
       press.time_ns, "mouse");
}

void ParticipantView::set_by_pointer(QPointF at, std::int64_t time_ns) {
  const std::optional<double> position = scene_page().position_at(press_->item, at);
  if (!position || press_->set == position) return;
  press_->set = position;
  Action mark = *press_->item.action;
  mark.position = *position;
  act(mark, time_ns, "mouse");
}

bool ParticipantView::has_use_for(const QKeyEvent& event) const {
  if (is_command_key(event)) return false;
  if (turned_by(event.key()) != nullptr) return true;
  if (action_of_key(*scene_, event.key(), sign_of_key(*scene_, event))) return true;
  if (scene_page().typing(*scene_) != ParticipantPage::Typing::text) return false;
  const QString text = event.text();
  return (!text.isEmpty() && text.front().isPrint()) || event.key() == Qt::Key_Backspace ||
         event.key() == Qt::Key_Delete;
}

bool ParticipantView::repeats(const QKeyEvent& event) const {
  if (is_command_key(event)) return false;
  const std::optional<Action> action = action_of_key(*scene_, event.key(), {});
  return action && action->what == Action::What::step;
}

bool ParticipantView::press(QKeyEvent& event, std::int64_t pressed_ns) {
  if (!has_use_for(event)) return false;
  if (const Item* turning = turned_by(event.key())) {
    turn_to(turning->action->number);
    return true;
  }
  const QString sign = sign_of_key(*scene_, event);
  std::optional<Action> action = action_of_key(*scene_, event.key(), sign);
  if (!action) {
    if (field_->isHidden()) turn_to(0);
    QApplication::sendEvent(field_, &event);
    return true;
  }
  const bool can_correct = action->what == Action::What::choose && scene_page().takes_two_digits();
  if (can_correct && pressed_ns - typed_ns_ < kTwoDigits_ns) {
    const std::string both = (typed_ + sign).toStdString();
    for (std::size_t i = 0; i < scene_->choices.size(); ++i) {
      if (scene_->choices[i].key == both) action->number = static_cast<int>(i) + 1;
    }
  }
  typed_ = sign;
  typed_ns_ = pressed_ns;
  act(*action, pressed_ns, "keyboard");
  return true;
}

void ParticipantView::act(const ParticipantAction& action, std::int64_t time_ns,
                          const char* source) {
  if (action.what == Action::What::turn_to) {
    turn_to(action.number);
    return;
  }
  ActionEffect effect = scene_page().act(*scene_, action, draft_);
  if (effect.told) {
    tell(*std::move(effect.told), time_ns, source);
  } else if (effect.shows_answer) {
    turn_to(0);
  } else {
    arrange();
  }
}

void ParticipantView::release(const QString& key, std::int64_t pressed_ns, double held_s) {
  if (keys_are_private()) return;
  tell({.kind = ParticipantInput::Kind::released, .text = key.toStdString(), .held_s = held_s},
       pressed_ns, "keyboard");
}

void ParticipantView::tell(ParticipantInput input, std::int64_t time_ns, const char* source) {
  input.time_ns = time_ns;
  input.source = source;
  emit acted(std::move(input));
}

// The text field writes the scene's answer, so its Return is the scene's; Shift+Return is a new line.
// Page up goes back to what was read before it.
bool ParticipantView::eventFilter(QObject* watched, QEvent* event) {
  if (watched == field_ && event->type() == QEvent::KeyPress) {
    auto& key = static_cast<QKeyEvent&>(*event);
    const bool is_return = key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter;
    const bool turns_back = key.key() == Qt::Key_PageUp && turned_by(Qt::Key_PageUp) != nullptr;
    if (turns_back || (is_return && !(key.modifiers() & Qt::ShiftModifier))) {
      if (!key.isAutoRepeat()) press(key, time_of_ns(key.timestamp()));
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace asperity
