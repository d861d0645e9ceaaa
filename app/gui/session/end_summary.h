// What a session came to, once it has ended.

#pragma once

#include <filesystem>

#include <QtCore/QStringList>
#include <QtWidgets/QWidget>

#include "app/gui/session/bad_moments.h"
#include "app/session/session_monitor.h"

class QLabel;
class QPushButton;

namespace asperity {

struct SessionOutcome {
  bool is_complete = false;
  bool can_go_on = false;  ///< it is in the store, neither complete nor ended by its protocol
  QString why{};           ///< what stopped it early; may be empty
  QStringList anchors{};   ///< how the responses to anchors changed
};

class EndSummary final : public QWidget {
  Q_OBJECT
 public:
  EndSummary(std::filesystem::path study, QWidget* parent = nullptr);
  /// `row.session` is 0 where none has begun.
  void show_end(const SessionSnapshot& snapshot, const SessionRow& row,
                const SessionOutcome& outcome);

 signals:
  void trials_wanted();
  void results_wanted();
  void close_wanted();
  void way_on_wanted(asperity::AfterFailure way);

 private:
  std::filesystem::path study_{};
  QPushButton* go_on_ = nullptr;
  QPushButton* start_again_ = nullptr;
  QPushButton* check_again_ = nullptr;
  QPushButton* see_table_ = nullptr;
  QPushButton* see_trials_ = nullptr;
  QLabel* title_ = nullptr;
  QLabel* text_ = nullptr;
  QLabel* place_ = nullptr;
};

}  // namespace asperity
