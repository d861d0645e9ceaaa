// Scrolls the page of a form so that the control in use stays in its place.

#include "app/gui/editor/form/used_control.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QEvent>
#include <QtCore/QTimer>
#include <QtGui/QCursor>
#include <QtWidgets/QApplication>
#include <QtWidgets/QScrollArea>
#include <QtWidgets/QScrollBar>

namespace asperity {

void send_layouts() { QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest); }

void UsedControl::rest_pointer() { resting_ = QCursor::pos(); }

QWidget* UsedControl::pointed(const QWidget& content) const {
  if (QCursor::pos() == resting_) return nullptr;
  QWidget* const control = QApplication::widgetAt(QCursor::pos());
  const bool is_control = control != nullptr && control->focusPolicy() != Qt::NoFocus;
  return is_control && content.isAncestorOf(control) ? control : nullptr;
}

void UsedControl::keep(const QWidget* content) {
  if (kept_ != nullptr || content == nullptr) return;
  focused_ = QApplication::focusWidget();
  QWidget* const pointed_to = pointed(*content);
  QWidget* const used = pointed_to != nullptr ? pointed_to : focused_.data();
  if (used == nullptr || !content->isAncestorOf(used)) return;
  kept_ = used;
  place_ = place_of(*used);
  is_in_sight_ = !used->visibleRegion().isEmpty();
  QTimer::singleShot(0, this, [this] {
    put_back();  // a label finds its height when it is shown
    kept_ = nullptr;
  });
}

void UsedControl::put_back() {
  if (kept_ == nullptr) return;
  send_layouts();
  // The layout can hide it, and a part that is made again moves the focus.
  if (!kept_->isVisible() || QApplication::focusWidget() != focused_) return;
  QScrollBar& bar = *area_.verticalScrollBar();
  bar.setValue(bar.value() + place_of(*kept_) - place_);
  if (is_in_sight_) area_.ensureWidgetVisible(kept_, 0, 0);
}

int UsedControl::place_of(const QWidget& control) const {
  return control.mapTo(area_.viewport(), QPoint()).y();
}

}  // namespace asperity
