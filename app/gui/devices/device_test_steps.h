// The steps of a device test as a list: what is done, what is under way, what is to come.

#pragma once

#include <optional>
#include <vector>

#include <QtCore/QString>
#include <QtWidgets/QWidget>

#include "app/device_bench/device_test.h"
#include "device/device_trait.h"

class QLabel;

namespace asperity {

/// What a person beside the device has to do, and what happens. `axis` as DeviceTestNews.
QString what_to_do(DeviceTestPart part, const std::optional<int>& axis);

class DeviceTestSteps final : public QWidget {
  Q_OBJECT
 public:
  explicit DeviceTestSteps(QWidget* parent = nullptr);

  /// What there is beside the timing of the loop.
  struct Parts {
    bool by_motors = true;
    bool by_a_person =
        true;  ///< who moves the handle of a real device along its borders, at the end
    /// Of the device that a simulated one stands for: what tells of nothing else is left out.
    std::vector<DeviceTrait> not_known{};
  };
  /// Everything is to come.
  void begin(const Parts& parts);
  void come_to(DeviceTestPart part);

 private:
  void write();

  struct Step {
    DeviceTestPart part = DeviceTestPart::timing;
    QString name{};
    std::optional<DeviceTrait> trait{};  ///< the only one that it tells of
    QLabel* label = nullptr;
  };
  std::vector<Step> steps_{};
  std::optional<DeviceTestPart> now_{};
};

}  // namespace asperity
