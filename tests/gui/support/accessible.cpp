// Walks through the widgets of a window by name, colour, place and order of focus.

#include "tests/gui/support/accessible.h"

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include <QtCore/QRegularExpression>
#include <QtGui/QTextDocument>
#include <QtWidgets/QAbstractButton>
#include <QtWidgets/QAbstractItemView>
#include <QtWidgets/QAbstractSpinBox>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QHeaderView>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>

#include "app/gui/look/theme.h"

namespace asperity {

namespace {

constexpr std::array kMeaningful{&Theme::fine, &Theme::look, &Theme::stop};

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

/// Where a control is seen from another one: what is scrolled out of sight of a list that does not contain the other is at
/// the edge of the list.
QRect place_of(const QWidget& control, const QWidget& other) {
  QRect place(control.mapTo(control.window(), QPoint(0, 0)), control.size());
  for (const QWidget* around = control.parentWidget(); around != nullptr && !around->isWindow();
       around = around->parentWidget()) {
    const auto* const scrolled = qobject_cast<const QAbstractScrollArea*>(around);
    if (scrolled == nullptr || scrolled->isAncestorOf(&other)) continue;
    const QRect seen(scrolled->mapTo(control.window(), QPoint(0, 0)), scrolled->size());
    place.setTop(std::clamp(place.top(), seen.top(), seen.bottom()));
    place.setBottom(std::clamp(place.bottom(), seen.top(), seen.bottom()));
  }
  return place;
}

}  // namespace

QStringList told_by_color_alone(const QWidget& window) {
  const auto means_something = [](const QColor& shown) {
    return std::any_of(kMeaningful.begin(), kMeaningful.end(),
                       [&shown](const auto& color) { return theme().*color == shown; });
  };
  const auto has_words_or_shape = [](const QString& text) {
    static const QRegularExpression kNumbers("[-−+]?\\d[\\d.,]*\\s*\\S{0,5}");  // with their units
    static const QRegularExpression kWords("\\p{L}{2}|[✓▲✕●■▼!]");
    return kWords.match(QString(text).remove(kNumbers)).hasMatch();
  };
  QStringList found{};
  for (const QLabel* label : window.findChildren<QLabel*>()) {
    if (!label->isVisible() || label->text().isEmpty()) continue;
    const QString written = label->text() + label->styleSheet();
    const bool is_colored =
        std::any_of(kMeaningful.begin(), kMeaningful.end(), [&written](const auto& color) {
          return written.contains((theme().*color).name(), Qt::CaseInsensitive);
        });
    QTextDocument plain{};
    plain.setHtml(label->text());
    if (is_colored && !has_words_or_shape(plain.toPlainText())) found << as_found(*label);
  }
  for (const QAbstractItemView* view : window.findChildren<QAbstractItemView*>()) {
    const bool is_header = qobject_cast<const QHeaderView*>(view) != nullptr;  // of the same model
    if (is_header || !view->isVisible() || view->model() == nullptr) continue;
    const QAbstractItemModel& cells = *view->model();
    for (int row = 0; row < cells.rowCount(); ++row) {
      for (int column = 0; column < cells.columnCount(); ++column) {
        const QModelIndex cell = cells.index(row, column);
        const QVariant color = cell.data(Qt::ForegroundRole);
        if (color.isValid() && means_something(color.value<QBrush>().color()) &&
            !has_words_or_shape(cell.data().toString())) {
          found << as_found(*view) + QString(" row %1, column %2: \"%3\"")
                                         .arg(row)
                                         .arg(column)
                                         .arg(cell.data().toString());
        }
      }
    }
  }
  return found;
}

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
    const QRect from = place_of(*course[i - 1], *course[i]);
    const QRect to = place_of(*course[i], *course[i - 1]);
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
