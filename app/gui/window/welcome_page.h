// What the study window shows while no study is open.

#pragma once

#include <filesystem>

#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QWidget>

#include "app/gui/base/session_wish.h"
#include "app/gui/base/settings.h"
#include "app/gui/look/background_task.h"

class QProgressBar;
class QTableWidget;

namespace asperity {

class Banner;

class WelcomePage final : public QWidget {
  Q_OBJECT
 public:
  explicit WelcomePage(QWidget* parent = nullptr);

  /// Opens the demo study where it is, or makes it first, which takes some seconds.
  void open_demo();
  /// Reads the list of recent studies anew.
  void show_recent();

 signals:
  void study_wanted(const std::filesystem::path& folder);
  void new_study_wanted();
  void open_wanted();
  /// Resumes an interrupted session of that study.
  void session_wanted(const std::filesystem::path& folder, const asperity::SessionWish& wish);
  void sessions_wanted(const std::filesystem::path& folder);

 private:
  QWidget* make_demo_card();
  QWidget* make_recent_card();
  void show_demo_place();
  void fill_recent(const std::vector<RecentStudy>& studies, const std::vector<bool>& present);
  /// Of the first of these studies that has one.
  void look_for_interrupted(const std::vector<RecentStudy>& studies);
  void show_working(bool working);

  Banner* banner_ = nullptr;
  Banner* interrupted_ = nullptr;
  QPushButton* demo_ = nullptr;
  QPushButton* demo_elsewhere_ = nullptr;
  QPushButton* cancel_ = nullptr;
  QLabel* demo_place_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QLabel* no_recent_ = nullptr;
  QTableWidget* recent_ = nullptr;
  QWidget* recent_buttons_ = nullptr;
  std::filesystem::path demo_parent_{};
  BackgroundTask demo_task_{};
  BackgroundTask recent_task_{};
  BackgroundTask interrupted_task_{};
};

}  // namespace asperity
