// Moves the controls of a widget in Qt's chain of focus to where the layout has it.

#include "app/gui/look/focus_order.h"

#include <algorithm>
#include <vector>

#include <QtWidgets/QLayout>
#include <QtWidgets/QWidget>

namespace asperity {

namespace {

/// Adds the widgets that the layout has before `strip`; false where it does not have `strip`.
bool add_widgets_before(const QWidget& strip, const QLayout& layout,
                        std::vector<const QWidget*>& before) {
  for (int i = 0; i < layout.count(); ++i) {
    QLayoutItem* const item = layout.itemAt(i);
    if (item->widget() == &strip) return true;
    if (item->widget() != nullptr) {
      before.push_back(item->widget());
    } else if (item->layout() != nullptr && add_widgets_before(strip, *item->layout(), before)) {
      return true;
    }
  }
  return false;
}

}  // namespace

void place_in_focus_order(QWidget& strip) {
  const QWidget* const page = strip.parentWidget();
  std::vector<const QWidget*> before{};
  if (page == nullptr || page->layout() == nullptr ||
      !add_widgets_before(strip, *page->layout(), before)) {
    return;
  }
  // Hidden ones too: they may be shown while the strip is.
  QWidget* last = nullptr;
  std::vector<QWidget*> own{};
  const QWidget* const window = strip.window();
  for (QWidget* at = window->nextInFocusChain(); at != window; at = at->nextInFocusChain()) {
    if ((at->focusPolicy() & Qt::TabFocus) != Qt::TabFocus) continue;
    const auto contains = [at](const QWidget* item) {
      return item == at || item->isAncestorOf(at);
    };
    if (contains(&strip)) {
      own.push_back(at);
    } else if (std::any_of(before.begin(), before.end(), contains)) {
      last = at;
    }
  }
  if (last == nullptr) return;
  for (QWidget* control : own) {
    QWidget::setTabOrder(last, control);
    last = control;
  }
}

}  // namespace asperity
