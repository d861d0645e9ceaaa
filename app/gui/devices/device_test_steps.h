// The steps of a device test as a list: what is done, what is under way, what is to come.

#pragma once

#include <optional>
#include <vector>

#include <QtCore/QString>
#include <QtWidgets/QWidget>

#include "app/tasks/device_test.h"

class QLabel;

namespace asperity {

/// What a person beside the device has to do, and what happens. `axis` as DeviceTestNews.
QString what_to_do(DeviceTestPart part, const std::optional<int>& axis);

class DeviceTestSteps final : public QWidget {
  Q_OBJECT
 public:
  explicit DeviceTestSteps(QWidget* parent = nullptr);

  /// Somebody moves the handle of a real device along its borders, at the end.
  enum class Workspace { by_a_person, left_out };
  /// Everything is to come.
  void begin(Workspace workspace);
  void come_to(DeviceTestPart part);

 private:
  void write();

  struct Step {
    DeviceTestPart part = DeviceTestPart::timing;
    QString name{};
    QLabel* label = nullptr;
  };
  std::vector<Step> steps_{};
  std::optional<DeviceTestPart> now_{};
};

}  // namespace asperity
