// What a session came to, once it has ended.

#pragma once

#include <filesystem>

#include <QtWidgets/QWidget>

#include "app/conductor/session_monitor.h"

class QLabel;

namespace asperity {

class EndSummary final : public QWidget {
  Q_OBJECT
 public:
  EndSummary(std::filesystem::path study, QWidget* parent = nullptr);
  /// `why`: what stopped it early; may be empty.
  void show_end(const SessionSnapshot& snapshot, const SessionRow& row, bool complete,
                const QString& why);

 signals:
  void trials_wanted();
  void results_wanted();
  void close_wanted();

 private:
  std::filesystem::path study_{};
  QLabel* title_ = nullptr;
  QLabel* text_ = nullptr;
  QLabel* place_ = nullptr;
};

}  // namespace asperity
