// Sees every tick of a session go by: what a monitor shows of them, and the device's buttons.

#pragma once

#include <cstdint>
#include <vector>

#include "app/conductor/respondent.h"
#include "app/conductor/session_monitor.h"
#include "renderers/tick_record.h"

namespace asperity {

/// Makes the monitor's bins of 1/60 s, knows how the loop has kept time in the last two seconds, and
/// notices when a button of the device goes down or up. Within attempts and between them.
///
/// pressing: p ← p + (F_z − p)·dt / (τ + dt), τ = 0.2 s, in newtons; F_z is the normal force that
/// was sent. Its quick part, the texture, is gone.
///
/// Threads: the conductor's.
class RecordWatch final {
 public:
  static constexpr double kPressing_s = 0.2;
  static constexpr double kHealth_s = 2.0;

  /// `monitor` may be null: then only buttons are noticed.
  explicit RecordWatch(SessionMonitor* monitor) : monitor_(monitor) {}

  /// Times on the session's clock, in order.
  void take(const TickRecord& record);

  std::vector<ButtonChange> take_button_changes();
  /// All but the lost records, which nobody sees go by.
  LoopHealth health() const;

 private:
  struct Tick {
    std::int64_t time_ns = 0;
    std::int32_t lateness_ns = 0;
  };
  void take_into_bin(const TickRecord& record);

  SessionMonitor* monitor_ = nullptr;
  std::uint32_t buttons_ = 0;
  std::vector<ButtonChange> button_changes_{};
  std::vector<Tick> ticks_{};  ///< the last two seconds and up to as many before
  std::uint64_t missed_deadlines_ = 0;
  std::uint64_t saturated_ticks_ = 0;
  LiveBin bin_{};
  bool bin_is_open_ = false;
  std::int64_t bin_began_ns_ = 0;
  std::int64_t last_ns_ = 0;
  double pressing_N_ = 0.0;
};

}  // namespace asperity
