// The thread on which a device is opened and measured, and what it and the window say to each other.

#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <QtCore/QObject>
#include <QtCore/QString>

#include "app/device_bench/measure_device.h"
#include "app/gui/devices/motion_bins.h"
#include "app/gui/look/background_task.h"
#include "device/drivers.h"

namespace asperity {

/// Opens a device and measures it, away from the GUI thread, which sends no force and reads no handle: see
/// `measure_device`, which the terminal calls as well.
///
/// Whoever begins has told somebody beside the device what it will do, and was told yes. A device that has to
/// move before it can be measured is asked about once more (`asked`), and waits for `answer`.
///
/// `stop` takes the force away at once, as does the end of this object, which waits for it.
///
/// Belongs to the GUI thread.
class DeviceTestRun final : public QObject {
  Q_OBJECT
 public:
  explicit DeviceTestRun(QObject* parent = nullptr);
  ~DeviceTestRun() override;

  /// `device` is as DriverRegistry::open takes it. Only while nothing runs.
  void begin(const DriverRegistry& drivers, const DriverOptions& options, const std::string& device,
             const MeasureOrder& order);
  void stop();
  bool is_running() const noexcept { return task_.is_running(); }
  void answer(bool agreed);
  /// What the device did since the last call.
  std::vector<MotionBin> take_motion();

 signals:
  void wished(const QString& sentence);  ///< what a person has to do, "pull the grip out…"
  void asked(const QString& sentence);   ///< whether the device may move
  void opened(const asperity::DeviceCapability& device);
  void came_to(const asperity::DeviceTestNews& news);
  void measured(const asperity::MeasuredDevice& device);
  /// As wanted: nothing was kept. `last_words`: what the driver says of a device that moved by itself then.
  void stopped(const QString& last_words);
  void failed(const QString& sentence);

 private:
  struct Talk;
  struct Outcome;
  std::shared_ptr<Talk> talk_;
  BackgroundTask task_{};
};

}  // namespace asperity
