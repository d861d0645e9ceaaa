// Ends the movement by which a device of Force Dimension finds its zero, when a stop is requested.

#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>
#include <utility>

#include "device/force_dimension/dhd_functions.h"

namespace asperity::force_dimension {

/// The end of an activity, for threads that wait for it.
class Ending final {
 public:
  void come() {
    {
      const std::lock_guard lock(mutex_);
      has_come_ = true;
    }
    changed_.notify_all();
  }
  /// Waits for the end or the stop. Whether the end came first.
  bool wait(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    return changed_.wait(lock, stop, [this] { return has_come_; });
  }
  /// Whether the end came in that time.
  bool wait_for(std::chrono::milliseconds longest) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, longest, [this] { return has_come_; });
  }

 private:
  std::mutex mutex_{};
  std::condition_variable_any changed_{};
  bool has_come_ = false;
};

/// Ends, during its lifetime, the movement of drdAutoInit in another thread as soon as a stop is requested.
///
/// drdAutoInit itself cannot be stopped. Its regulation is a thread of the SDK, which other calls can influence. It is
/// not documented whether the regulation switches the force on once more before it ends, nor whether the calls return
/// meanwhile. Therefore dhdStop and drdStop are repeated until it has ended, each in a separate thread.
class MovementEnder final {
 public:
  MovementEnder(const DhdFunctions& sdk, char id, const std::stop_token& stop)
      : takes_force_([this, &sdk, id, stop] { repeat(stop, [&sdk, id] { sdk.dhdStop(id); }); }),
        ends_regulation_(
            [this, &sdk, id, stop] { repeat(stop, [&sdk, id] { sdk.drdStop(false, id); }); }) {}
  ~MovementEnder() { ending_.come(); }
  MovementEnder(const MovementEnder&) = delete;
  MovementEnder& operator=(const MovementEnder&) = delete;

 private:
  static constexpr std::chrono::milliseconds kBetweenStops{10};

  template <typename Call>
  void repeat(const std::stop_token& stop, const Call& call) {
    if (ending_.wait(stop)) return;
    do call();
    while (!ending_.wait_for(kBetweenStops));
  }

  Ending ending_{};
  std::jthread takes_force_;
  std::jthread ends_regulation_;
};

/// Calls `tell` once if it still exists a second after a stop was requested. It calls no function of the SDK, because the
/// reason may be that these do not return.
class OverdueStop final {
 public:
  OverdueStop(const std::stop_token& stop, std::function<void()> tell)
      : thread_([this, stop, tell = std::move(tell)] {
          if (!ending_.wait(stop) && !ending_.wait_for(kToGiveUp)) tell();
        }) {}
  ~OverdueStop() { ending_.come(); }
  OverdueStop(const OverdueStop&) = delete;
  OverdueStop& operator=(const OverdueStop&) = delete;

 private:
  static constexpr std::chrono::seconds kToGiveUp{1};

  Ending ending_{};
  std::jthread thread_;
};

}  // namespace asperity::force_dimension
