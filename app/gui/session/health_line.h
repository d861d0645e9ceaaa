// How the device loop keeps time, and where the data go.

#pragma once

#include <QtCore/QString>
#include <QtWidgets/QWidget>

#include "app/gui/session/session_form.h"
#include "app/session/session_monitor.h"

class QLabel;

namespace asperity {

class StateLabel;

class HealthLine final : public QWidget {
  Q_OBJECT
 public:
  explicit HealthLine(QWidget* parent = nullptr);
  /// `facts` may be null.
  /// `only_tried`: a trial with the mouse, of which nothing is stored.
  void show_health(const SessionSnapshot& snapshot, const SessionFacts* facts, bool only_tried);
  /// In two lines where one is too short.
  void set_form(SessionForm form);

 private:
  static QString text_of(MaskingState masking);

  StateLabel* health_ = nullptr;
  QLabel* stored_ = nullptr;
};

}  // namespace asperity
