// The checklist before a session, line by line.

#pragma once

#include <vector>

#include <QtWidgets/QWidget>

#include "app/tasks/session_checks.h"

class QGridLayout;
class QLabel;
class QPushButton;

namespace asperity {

/// Each line has a shape (✓ ▲ ✕), what was found and, where something is to be done, what. While it
/// is gone through anew the last result stays in sight, greyed.
class CheckList final : public QWidget {
  Q_OBJECT
 public:
  explicit CheckList(QWidget* parent = nullptr);

  /// Shown are first those that keep the session from starting, then those to look at.
  void set_checks(std::vector<SessionCheck> checks);
  void set_running(bool running);
  /// Of the comparison with the device, 0 to 1, while everything is gone through.
  void set_progress(double fraction);

 signals:
  void again_wanted();

 private:
  QLabel* summary_ = nullptr;
  QWidget* lines_ = nullptr;
  QGridLayout* grid_ = nullptr;
  QPushButton* again_ = nullptr;
};

}  // namespace asperity
