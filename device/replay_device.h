// A recording as a hand: it moves as somebody once moved, and feels nothing.

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "device/haptic_device.h"

namespace asperity {

/// Gives the states of a recording again, at the distances of time at which they were taken, from the first reading
/// on: at each reading the latest state that is due, exactly as it was but for its time. After the last one the
/// hand rests where it was, at velocity 0, with no button down.
///
/// It has no motors: pushes are taken and have no effect, so that a recording can be led over another surface.
///
/// Errors: the constructor throws std::invalid_argument for no states at all, and for times that do not rise.
///
/// Real-time: reading does not allocate, lock or throw.
class ReplayDevice final : public HapticDevice {
 public:
  explicit ReplayDevice(std::vector<ProbeState> states);

  /// Whether the last state has been given. From the thread that reads.
  bool is_over() const noexcept { return is_over_; }

 private:
  bool do_read(std::int64_t now_ns, ProbeState& state) noexcept override;
  bool do_send(const Wrench&) noexcept override { return true; }

  std::vector<ProbeState> states_{};
  std::size_t at_ = 0;  ///< the state given last
  std::int64_t began_ns_ = 0;
  bool has_begun_ = false;
  bool is_over_ = false;
};

}  // namespace asperity
