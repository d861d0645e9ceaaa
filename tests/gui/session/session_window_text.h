// What tests read in the experimenter's window and enter into it.

#pragma once

#include <string>
#include <vector>

#include <QtCore/QStringList>
#include <QtWidgets/QAbstractItemView>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>

#include "app/session/session_requests.h"
#include "tests/gui/support/widgets.h"

namespace asperity {

/// Everything that a person can read in a window, tool tips included.
inline QStringList texts_of(const QWidget& window) {
  QStringList texts{window.windowTitle()};
  for (const QWidget* widget : window.findChildren<QWidget*>()) {
    texts += {widget->toolTip(), widget->windowTitle(), widget->accessibleName()};
    for (const char* const property : {"text", "placeholderText", "words"}) {
      texts += widget->property(property).toString();
    }
    const auto* view = qobject_cast<const QAbstractItemView*>(widget);
    if (view == nullptr || view->model() == nullptr) continue;
    const QAbstractItemModel& model = *view->model();
    for (int row = 0; row < model.rowCount(); ++row) {
      for (int column = 0; column < model.columnCount(); ++column) {
        for (int role = 0; role <= Qt::UserRole + 8; ++role) {
          const QVariant value = model.index(row, column).data(role);
          if (value.typeId() == QMetaType::QString) texts += value.toString();
        }
      }
    }
  }
  return texts;
}

/// Types a reason in its field, and confirms it.
inline void give_reason(const QWidget& window, const QString& reason) {
  child<QLineEdit>(window, "reason").setText(reason);
  child<QPushButton>(window, "reason_given").click();
}

/// "note", "skipped", …
inline std::vector<std::string> kinds(const std::vector<SessionRequests::Remark>& remarks) {
  std::vector<std::string> names{};
  for (const auto& remark : remarks) names.push_back(remark.kind);
  return names;
}

}  // namespace asperity
