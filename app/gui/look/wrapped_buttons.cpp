// Places buttons row by row; the height follows from the width by the same computation.

#include "app/gui/look/wrapped_buttons.h"

#include <algorithm>
#include <utility>

#include <QtCore/QEvent>
#include <QtWidgets/QPushButton>

#include "app/gui/look/theme.h"

namespace asperity {

WrappedButtons::WrappedButtons(QWidget* parent) : QWidget(parent) {
  QSizePolicy policy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
}

void WrappedButtons::set_buttons(const QList<QPushButton*>& buttons) {
  for (QPushButton* before : std::as_const(buttons_)) {
    before->hide();
    before->deleteLater();  // a click on one of them may be what asks anew
  }
  buttons_ = buttons;
  for (QPushButton* button : buttons_) button->show();
  updateGeometry();
  place(width());
}

int WrappedButtons::heightForWidth(int width) const { return place_within(width, nullptr); }

QSize WrappedButtons::sizeHint() const { return {0, place_within(width(), nullptr)}; }

bool WrappedButtons::event(QEvent* event) {
  // A button was shown or hidden, or has another text.
  if (event->type() == QEvent::LayoutRequest) {
    place(width());
    updateGeometry();
  }
  return QWidget::event(event);
}

void WrappedButtons::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  place(width());
  updateGeometry();
}

void WrappedButtons::place(int width) {
  place_within(width, [](QPushButton& button, const QRect& where) { button.setGeometry(where); });
}

int WrappedButtons::place_within(int width, void (*put)(QPushButton&, const QRect&)) const {
  int x = 0;
  int y = 0;
  int height = 0;
  for (QPushButton* button : buttons_) {
    if (button->isHidden()) continue;
    const QSize size = button->sizeHint().boundedTo({width, QWIDGETSIZE_MAX});
    if (x > 0 && x + size.width() > width) {
      x = 0;
      y = height + kGrid;
    }
    if (put != nullptr) put(*button, QRect(QPoint(x, y), size));
    height = std::max(height, y + size.height());
    x += size.width() + kGrid;
  }
  return height;
}

}  // namespace asperity
