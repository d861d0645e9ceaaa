// Compares the size of each visible label and button with what its words need.

#include "tests/gui/session/clipped.h"

#include <QtGui/QTextDocument>
#include <QtWidgets/QAbstractButton>
#include <QtWidgets/QAbstractScrollArea>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLayout>

#include "app/gui/look/fitted_label.h"

namespace asperity {

namespace {

QString name_of(const QWidget& widget) {
  const QString text = widget.property("text").toString();
  return QString("%1 “%2” in %3 × %4")
      .arg(widget.objectName().isEmpty() ? widget.metaObject()->className() : widget.objectName(),
           text)
      .arg(widget.width())
      .arg(widget.height());
}

/// The room that the words of a label need at its width.
QSize needed(const QLabel& label) {
  if (label.text().isEmpty()) return {};
  if (qobject_cast<const FittedLabel*>(&label) != nullptr) {
    return {0, label.fontMetrics().height()};
  }
  if (label.wordWrap()) {
    const int height = label.heightForWidth(label.width());
    return {label.minimumSizeHint().width(), height};
  }
  return label.sizeHint();
}

bool scrolls(const QWidget& widget) {
  for (const QWidget* each = widget.parentWidget(); each != nullptr; each = each->parentWidget()) {
    if (qobject_cast<const QAbstractScrollArea*>(each) != nullptr) return true;
  }
  return false;
}

}  // namespace

QStringList clipped_in(const QWidget& window) {
  QStringList clipped{};
  QList<const QWidget*> leaves{};
  for (const QWidget* widget : window.findChildren<QWidget*>()) {
    if (!widget->isVisible() || widget->window() != &window || scrolls(*widget)) continue;
    const QRect place(widget->mapTo(&window, QPoint(0, 0)), widget->size());
    if (!window.rect().contains(place) ||
        !widget->parentWidget()->rect().contains(widget->geometry())) {
      clipped += name_of(*widget) + " sticks out";
    }
    const auto* label = qobject_cast<const QLabel*>(widget);
    const auto* button = qobject_cast<const QAbstractButton*>(widget);
    QSize least{};
    if (label != nullptr) least = needed(*label);
    if (button != nullptr && widget->objectName() != "phrase") least = button->sizeHint();
    // A title that is cut says so with an ellipsis.
    if (widget->objectName() == "session_title") least.setWidth(0);
    if (least.width() > widget->width() || least.height() > widget->height() + 1) {
      clipped +=
          QString("%1 needs %2 × %3").arg(name_of(*widget)).arg(least.width()).arg(least.height());
    }
    if (widget->layout() == nullptr && widget->findChildren<QWidget*>().isEmpty()) {
      leaves += widget;
    }
  }
  for (int i = 0; i < leaves.size(); ++i) {
    for (int j = 0; j < i; ++j) {
      const QRect one(leaves[i]->mapTo(&window, QPoint(0, 0)), leaves[i]->size());
      const QRect other(leaves[j]->mapTo(&window, QPoint(0, 0)), leaves[j]->size());
      if (one.intersects(other)) {
        clipped += name_of(*leaves[i]) + " lies over " + name_of(*leaves[j]);
      }
    }
  }
  return clipped;
}

}  // namespace asperity
