// Testing a device: what it will do, the steps while it does them, what it was measured to be, now and before.

#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <QtCore/QTimer>

#include "app/gui/base/study_page.h"
#include "app/gui/devices/device_test_run.h"
#include "app/gui/devices/tested_device.h"

class QBoxLayout;
class QComboBox;
class QDoubleSpinBox;
class QProgressBar;
class QScrollArea;
class QStackedWidget;

namespace asperity {

class DeviceTestSteps;
class MotionPicture;
class ProfileView;
class StudyTable;

/// `asperity device-test` in the window. A real device is opened only after somebody has read what it will do and
/// pressed; a device that has to move before that is asked about once more. While it is measured there is a
/// button, and keys, that take the force away at once; so does everything that takes the page out of sight.
class DeviceTestPage final : public StudyPage {
  Q_OBJECT
 public:
  explicit DeviceTestPage(OpenStudy& study, QWidget* parent = nullptr);
  /// `usual` is what is measured unless something else is chosen here, for tests.
  DeviceTestPage(OpenStudy& study, MeasureOrder usual, QWidget* parent);
  ~DeviceTestPage() override;

  /// Shows what will be done, and the profiles that there are. Nothing is opened. While a device is measured
  /// it stays.
  void show_device(const TestedDevice& device);
  bool is_measuring() const noexcept { return run_.is_running(); }

 signals:
  void back_wanted();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  /// A protocol that has limits of its own.
  struct Limits {
    QString name{};
    double rate_Hz = 1000.0;
    std::map<std::string, double> limits{};
  };
  /// What the study has for this device.
  struct Found {
    KeptProfiles kept{};
    std::vector<Limits> limits{};
    std::string now_utc{};
  };
  static Found look_into(const Study& study, const WhichDevice& device);

  QWidget* make_overview();
  QWidget* make_order_card(QWidget* parent);
  QWidget* make_profiles_card(QWidget* parent);
  QWidget* make_course();
  void connect_run();
  void show_found(const Found& found);
  /// Null where those are the usual ones.
  const Limits* chosen_limits() const;
  void show_limits();
  void write_what_it_does();
  void begin();
  void offer_stop();
  void stop();
  void ask(const QString& sentence);
  void drop_question();
  void show_news(const DeviceTestNews& news);
  void show_measured(const MeasuredDevice& measured);
  void end(State state, const QString& sentence);
  void arrange();

  MeasureOrder usual_{};
  TestedDevice device_{};
  Found found_{};
  std::string shown_utc_{};  ///< of the profile that is shown

  QPushButton* back_ = nullptr;
  QStackedWidget* stack_ = nullptr;
  QBoxLayout* cards_ = nullptr;
  QScrollArea* area_ = nullptr;
  QLabel* device_name_ = nullptr;
  StateLabel* what_ = nullptr;
  QComboBox* limits_ = nullptr;
  QLabel* limits_text_ = nullptr;
  QDoubleSpinBox* force_ = nullptr;
  QPushButton* begin_ = nullptr;
  QPushButton* not_now_ = nullptr;
  QLabel* reason_ = nullptr;
  StudyTable* profiles_ = nullptr;
  QLabel* profile_problems_ = nullptr;  ///< there are none, or some cannot be read
  ProfileView* profile_ = nullptr;

  DeviceTestSteps* steps_ = nullptr;
  QLabel* do_now_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QWidget* question_ = nullptr;
  StateLabel* question_text_ = nullptr;
  MotionPicture* picture_ = nullptr;
  QPushButton* stop_ = nullptr;
  QTimer frames_{};
  bool stop_wanted_ = false;
  StimulusExaminer::Hold hold_{};
  DeviceTestRun run_{};  ///< the last: it is stopped and waited for before anything else goes
};

}  // namespace asperity
