// The study that the window shows: its folder, a reader of its own, and news of changes.

#pragma once

#include <any>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <QtCore/QObject>

#include "app/device_bench/tried_device.h"
#include "app/gui/base/loaded_models.h"
#include "app/gui/base/stimulus_examiner.h"
#include "device/drivers.h"
#include "renderers/force/force_model.h"
#include "results_schema/study.h"

namespace asperity {

/// Belongs to the GUI thread. Only reads: what writes (a session, a task) opens the study itself and
/// then calls `announce_change`.
class OpenStudy final : public QObject {
  Q_OBJECT
 public:
  /// Errors: ResultsError as Study::open.
  explicit OpenStudy(const std::filesystem::path& folder, LoadedModels models = {},
                     QObject* parent = nullptr);

  const std::filesystem::path& folder() const noexcept { return study_.folder(); }
  const Study& study() const noexcept { return study_; }
  /// Otherwise it is only looked at: what would write is disabled, and says so.
  bool can_be_written() const noexcept { return can_be_written_; }
  const ModelRegistry& models() const noexcept { return models_.models; }
  /// Why plug-ins of the settings could not be loaded, a sentence each.
  const std::vector<std::string>& plugin_problems() const noexcept { return models_.problems; }
  /// What a session here may run on: pages and sessions ask the drivers through this registry, which asks
  /// each one thing at a time.
  const DriverRegistry& drivers() const noexcept { return drivers_; }
  /// Before pages are made.
  void set_drivers(DriverRegistry drivers) { drivers_ = std::move(drivers); }
  /// How pages try a device before a session.
  const DeviceTrial& device_trial() const noexcept { return device_trial_; }
  void set_device_trial(DeviceTrial trial) { device_trial_ = std::move(trial); }
  /// Of the sessions that begin here (RunInputs); a test on a busy machine sets longer times.
  const ServoSettings& servo() const noexcept { return servo_; }
  void set_servo(const ServoSettings& settings) noexcept { servo_ = settings; }
  /// Examines the stimuli of protocols for all pages.
  StimulusExaminer& examiner() noexcept { return examiner_; }
  /// Everybody who shows the study reads it again.
  void announce_change() { emit changed(); }
  /// What a page leaves to the one that is made in its place for another theme or language; empty
  /// when none has left anything. Taken once.
  void leave(const std::string& page, std::any what) { left_[page] = std::move(what); }
  std::any take_left(const std::string& page) { return std::exchange(left_[page], {}); }

 signals:
  void changed();

 private:
  Study study_;
  bool can_be_written_ = true;
  LoadedModels models_{};
  DriverRegistry drivers_ = built_in_drivers();
  DeviceTrial device_trial_ = try_device;
  ServoSettings servo_{};
  StimulusExaminer examiner_;
  std::map<std::string, std::any> left_{};
};

}  // namespace asperity
