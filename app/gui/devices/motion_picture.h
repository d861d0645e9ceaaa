// What a device does at this moment while it is measured: where its handle moves and how it is pushed.

#pragma once

#include <memory>
#include <vector>

#include <QtWidgets/QWidget>

#include "app/gui/devices/motion_bins.h"
#include "device/device_capability.h"

namespace asperity {

/// Over the last seconds the handle's motion from where it was when the step began, and the force sent, along x, y
/// and z; of the step in which somebody moves the handle along its borders instead its path from above and from
/// the front, with the workspace that the driver tells.
class MotionPicture final : public QWidget {
  Q_OBJECT
 public:
  static constexpr double kShown_s = 4.0;

  explicit MotionPicture(QWidget* parent = nullptr);
  ~MotionPicture() override;

  /// Nothing is drawn any more.
  void begin();
  void set_device(const DeviceCapability& device);
  void come_to(DeviceTestPart part);
  void take(const std::vector<MotionBin>& bins);

  /// For tests: how many points are drawn of each curve, and of the path in the workspace.
  int points() const;
  int path_points() const;

 private:
  struct Drawing;
  void draw();

  std::unique_ptr<Drawing> drawing_;
};

}  // namespace asperity
