// A haptic device that keeps time itself.

#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <limits>
#include <mutex>
#include <string>
#include <thread>

#include "device/call_gate.h"
#include "device/haptic_device.h"

namespace asperity {

/// Calls from a thread of its own every half millisecond, unless a test silences or hangs it.
class CallingDevice final : public HapticDevice {
 public:
  CallingDevice()
      : HapticDevice({.name = "calling", .peak_force_N = 10.0, .pacing = Pacing::theirs}, {}) {}
  ~CallingDevice() override {
    stop_calls();
    {
      const std::lock_guard lock(mutex_);
      hangs_ = false;
      ends_ = true;
    }
    changed_.notify_all();
    if (thread_.joinable()) thread_.join();
  }

  std::atomic<bool> is_silent{false};
  /// After so many readings it is lost, and reports a reason until its calls are stopped.
  std::atomic<int> readings_left{std::numeric_limits<int>::max()};
  std::atomic<int> turned_away{0};  ///< calls that came to a closed gate
  std::atomic<double> last_force_N{-1.0};
  std::atomic<bool> holds_calls_from_outside{false};
  std::atomic<bool> is_called_from_outside{false};
  double rate_Hz = 0.0;  ///< that was asked for

  /// Returns when its thread hangs, outside of a call.
  void hang() {
    std::unique_lock lock(mutex_);
    hangs_ = true;
    changed_.wait(lock, [this] { return is_hanging_; });
  }
  void release() {
    {
      const std::lock_guard lock(mutex_);
      hangs_ = false;
    }
    changed_.notify_all();
  }

  void start_calls(const TickCall& call) override {
    rate_Hz = call.rate_Hz;
    gate_.open(call);
    if (!thread_.joinable()) thread_ = std::thread([this] { call_often(); });
  }
  void stop_calls() noexcept override {
    gate_.close();
    is_lost_ = false;
  }
  void zero_force_from_outside() noexcept override {
    is_called_from_outside = true;
    while (holds_calls_from_outside) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    last_force_N.store(0.0);
  }
  std::string trouble() const override { return is_lost_ ? "The Calling 7 is too warm." : ""; }

 private:
  void call_often() {
    std::unique_lock lock(mutex_);
    while (!ends_) {
      if (hangs_) {
        is_hanging_ = true;
        changed_.notify_all();
        changed_.wait(lock, [this] { return !hangs_; });
        is_hanging_ = false;
      }
      lock.unlock();
      if (!is_silent.load() && !gate_.pass()) ++turned_away;
      std::this_thread::sleep_for(std::chrono::microseconds(500));
      lock.lock();
    }
  }
  bool do_read(std::int64_t, ProbeState&) noexcept override {
    is_lost_ = readings_left-- <= 0;
    return !is_lost_;
  }
  bool do_send(const Wrench& limited) noexcept override {
    last_force_N.store(limited.force_N.z);
    return true;
  }

  CallGate gate_{};
  std::atomic<bool> is_lost_{false};
  std::mutex mutex_{};
  std::condition_variable changed_{};
  bool hangs_ = false;
  bool is_hanging_ = false;
  bool ends_ = false;
  std::thread thread_{};
};

}  // namespace asperity
