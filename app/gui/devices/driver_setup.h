// Telling drivers where things are that they do not find by themselves: a firmware, a library, a service.

#pragma once

#include <memory>
#include <string>
#include <vector>

#include <QtWidgets/QDialog>

#include "app/device_bench/device_survey.h"

class QLineEdit;
class QScrollArea;

namespace asperity {

class StateLabel;

/// A line for each driver: what it is told, a button that chooses a file, one that clears, and what the driver says of
/// it. What is named is remembered at once (`driver_place`), right or wrong: the driver judges.
///
/// Whoever opens it looks for devices when something has changed, and shows here what was found: the list of devices
/// and this say the same.
class DriverSetup final : public QDialog {
  Q_OBJECT
 public:
  /// Those of `drivers` that have to be told something.
  explicit DriverSetup(const std::vector<std::string>& drivers, QWidget* parent = nullptr);
  ~DriverSetup() override;

  void show_looking();
  void show_found(const std::vector<SurveyedDriver>& drivers);
  void show_failure(const QString& what);

 signals:
  void changed();

 public slots:
  void done(int result) override;

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  struct Line;

  void add_line(const std::string& driver);
  void choose_file(Line& line);
  /// Remembers what is typed; false where it can be no place.
  bool take(Line& line);
  void leave();
  /// A field that loses the focus because it goes out of sight has not been filled in.
  void stop_listening();
  /// As high as its words need, where the screen has room, and `least`: what is shown does not shrink.
  void fit(int least);

  std::vector<std::unique_ptr<Line>> lines_{};
  QScrollArea* area_ = nullptr;
  QWidget* inside_ = nullptr;
};

/// The ids of those that have to be told something.
std::vector<std::string> drivers_to_set_up(const DriverRegistry& drivers);

/// What there is to be told, in a sentence or two, for a button that opens a DriverSetup.
QString what_to_set_up(const std::string& driver);

}  // namespace asperity
