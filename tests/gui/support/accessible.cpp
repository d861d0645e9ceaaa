#include "tests/gui/support/accessible.h"

#include <algorithm>
#include <set>
#include <vector>

#include <QtWidgets/QAbstractButton>
#include <QtWidgets/QAbstractItemView>
#include <QtWidgets/QAbstractSpinBox>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>

namespace asperity {

namespace {

/// Inside another control, which is the one that has a name.
bool is_part_of_a_control(const QWidget& widget) {
  for (const QWidget* around = widget.parentWidget(); around != nullptr;
       around = around->parentWidget()) {
    if (qobject_cast<const QAbstractSpinBox*>(around) != nullptr ||
        qobject_cast<const QComboBox*>(around) != nullptr ||
        qobject_cast<const QLineEdit*>(around) != nullptr ||
        qobject_cast<const QAbstractItemView*>(around) != nullptr) {
      return true;
    }
  }
  return widget.objectName().startsWith("qt_");
}

bool is_control(const QWidget& widget) {
  const bool is_used = qobject_cast<const QAbstractButton*>(&widget) != nullptr ||
                       (widget.focusPolicy() & Qt::TabFocus) == Qt::TabFocus;
  return is_used && widget.isVisible() && !is_part_of_a_control(widget);
}

QString name_read_out(const QWidget& control) {
  if (!control.accessibleName().isEmpty()) return control.accessibleName();
  if (const auto* button = qobject_cast<const QAbstractButton*>(&control)) return button->text();
  for (const QLabel* label : control.window()->findChildren<QLabel*>()) {
    if (label->buddy() == &control) return label->text();
  }
  return {};
}

QString as_found(const QWidget& control) {
  const QString name = name_read_out(control);
  return QString("%1 \"%2\"%3")
      .arg(control.metaObject()->className(), control.objectName(),
           name.isEmpty() ? QString() : " (" + name.simplified() + ')');
}

QRect place_of(const QWidget& control) {
  return {control.mapTo(control.window(), QPoint(0, 0)), control.size()};
}

}  // namespace

QStringList nameless_controls(const QWidget& window) {
  QStringList nameless{};
  for (const QWidget* widget : window.findChildren<QWidget*>()) {
    if (widget->window() != &window || !is_control(*widget)) continue;
    const QString name = name_read_out(*widget);
    const bool has_letter =
        std::any_of(name.begin(), name.end(), [](QChar c) { return c.isLetter(); });
    if (!has_letter) nameless << as_found(*widget);
  }
  return nameless;
}

QStringList steps_against_reading(const QWidget& window) {
  std::vector<const QWidget*> course{};
  const QWidget* widget = window.nextInFocusChain();
  for (; widget != nullptr && widget != &window; widget = widget->nextInFocusChain()) {
    const bool is_reached = (widget->focusPolicy() & Qt::TabFocus) == Qt::TabFocus;
    if (is_reached && is_control(*widget)) course.push_back(widget);
  }
  QStringList steps{};
  for (std::size_t i = 1; i < course.size(); ++i) {
    const QRect from = place_of(*course[i - 1]);
    const QRect to = place_of(*course[i]);
    const bool is_above = to.bottom() < from.top();
    const bool is_left = to.right() < from.left();
    const bool is_right = to.left() > from.right();
    const bool is_below = to.top() > from.bottom();
    if ((is_above && !is_right) || (is_left && !is_below)) {
      steps << as_found(*course[i - 1]) + " → " + as_found(*course[i]);
    }
  }
  return steps;
}

}  // namespace asperity
