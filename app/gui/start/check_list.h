// The checklist before a session, line by line.

#pragma once

#include <string>
#include <vector>

#include <QtWidgets/QWidget>

#include "app/tasks/checks/session_check.h"

class QGridLayout;
class QLabel;
class QProgressBar;
class QPushButton;
class QScrollArea;

namespace asperity {

/// Each line has a shape (✓ ▲ ✕), what was found and, where something is to be done, what. While the checks run
/// there are a bar and a button to cancel them in place of the lines.
class CheckList final : public QWidget {
  Q_OBJECT
 public:
  explicit CheckList(QWidget* parent = nullptr);

  /// Below the summary; empty: nothing. Of something that the session does not wait for.
  void set_note(const QString& note);
  /// Shown are first those that keep the session from starting, then those to look at. `protocol`: the text that warnings
  /// are about.
  void set_checks(std::vector<SessionCheck> checks, const std::string& protocol = {});
  void set_running(bool running);
  /// Of the comparison with the device, 0 to 1, while the checks run.
  void set_progress(double fraction);
  /// In place of `set_checks`: they were cancelled, and nothing is known.
  void set_cancelled();

 signals:
  void again_wanted();
  /// Once for every run.
  void cancel_wanted();

 private:
  QLabel* summary_ = nullptr;
  QLabel* note_ = nullptr;
  QScrollArea* area_ = nullptr;  ///< hidden while there are no lines
  QWidget* lines_ = nullptr;
  QGridLayout* grid_ = nullptr;
  QPushButton* again_ = nullptr;
  QWidget* course_ = nullptr;  ///< bar and button, while the checks run
  QProgressBar* bar_ = nullptr;
  QPushButton* cancel_ = nullptr;
};

}  // namespace asperity
