// The devices that a session can run on, what each can do, and what would make the others usable.

#pragma once

#include <functional>
#include <map>
#include <stop_token>
#include <string>
#include <vector>

#include <QtCore/QPointer>

#include "app/device_bench/device_survey.h"
#include "app/gui/base/study_page.h"
#include "app/gui/devices/tested_device.h"
#include "app/gui/look/background_task.h"

class QFrame;
class QPushButton;

namespace asperity {

class DriverSetup;
class StateLabel;

/// Looks for devices when it is first shown, again when asked, and when drivers are told something else (`DriverSetup`,
/// by the button of a driver that needs it); that takes seconds, in the background.
class DevicesPage final : public StudyPage {
  Q_OBJECT
 public:
  /// What every driver finds; runs on a thread of its own.
  using Survey = std::function<std::vector<SurveyedDriver>(const std::stop_token&)>;

  explicit DevicesPage(OpenStudy& study, QWidget* parent = nullptr);
  DevicesPage(OpenStudy& study, Survey survey, QWidget* parent);

  /// "1 ready"
  QString count() const;

 signals:
  void test_wanted(const asperity::TestedDevice& device);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void add_simulated();
  void add_models();  ///< what the simulated device can stand for
  void look();
  void show_found(const std::vector<SurveyedDriver>& drivers);
  void add_driver(const SurveyedDriver& driver);
  void set_up(const std::string& driver);
  QPushButton* make_test_button(const TestedDevice& device, QWidget* parent);

  Survey survey_{};
  int simulated_ = 0;
  int attached_ = 0;
  bool looked_ = false;
  std::map<std::string, std::string> told_{};  ///< driver_places() when it looked last
  std::vector<SurveyedDriver> drivers_{};      ///< as it found them
  QPointer<DriverSetup> setup_{};
  QPushButton* look_button_ = nullptr;
  QVBoxLayout* cards_ = nullptr;
  StateLabel* udev_ = nullptr;  ///< what is missing of udev's, where something is
  QWidget* found_ = nullptr;    ///< the cards of the drivers, made anew with every look
  QFrame* models_ = nullptr;
  BackgroundTask task_{};
};

}  // namespace asperity
