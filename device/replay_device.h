// A recording as a hand: it repeats recorded movements, and feels nothing.

#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "device/drivers.h"
#include "device/haptic_device.h"

namespace asperity {

/// What comes after the last state of a recording.
enum class ReplayEnd {
  rest,  ///< the hand stays where it was, at velocity 0, with no button down
  lost,  ///< the device does not answer any more
};

/// Gives the states of a recording again, at the distances of time at which they were taken, from the first reading
/// on, and again from the first reading of each attempt on: at each reading the latest state that is due, exactly as it was but for its time. What
/// comes after the last one is `ReplayEnd`.
///
/// It has no motors: pushes are taken and have no effect, so that a recording can be led over another surface.
///
/// Errors: the constructor throws std::invalid_argument for no states at all, and for times that do not rise.
///
/// Real-time: reading does not allocate, lock or throw.
class ReplayDevice final : public HapticDevice {
 public:
  /// `source` is where the states come from, for the device's remarks.
  explicit ReplayDevice(std::vector<ProbeState> states, ReplayEnd end = ReplayEnd::rest,
                        const std::string& source = {});

  /// Whether the last state has been given. From the thread that reads.
  bool is_over() const noexcept { return is_over_; }

  void begin_attempt() noexcept override { begins_.store(true); }
  void zero_force_from_outside() noexcept override {}

 private:
  bool do_read(std::int64_t now_ns, ProbeState& state) noexcept override;
  bool do_send(const Wrench&) noexcept override { return !is_lost_; }

  std::vector<ProbeState> states_{};
  ReplayEnd end_ = ReplayEnd::rest;
  std::size_t at_ = 0;  ///< the state given last
  std::int64_t began_ns_ = 0;
  std::atomic<bool> begins_{false};
  bool has_begun_ = false;
  bool is_over_ = false;
  bool is_lost_ = false;
};

/// "replay:FILE": the hand of a recording, read by DriverOptions::recorded_hand.
Driver replay_driver();

}  // namespace asperity
