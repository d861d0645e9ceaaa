// Observes every tick of a session: for the monitor, and for the device's buttons.

#pragma once

#include <cstdint>
#include <vector>

#include "app/session/respondents/respondent.h"
#include "app/session/rig/contact_reader.h"
#include "app/session/session_monitor.h"
#include "renderers/servo/tick_record.h"

namespace asperity {

/// Makes the monitor's bins of 1/60 s, measures the timing of the loop over the last two seconds,
/// and detects presses and releases of the device's buttons, within attempts and between them.
/// Within an attempt it also follows the hand (HandWatch).
///
/// Threads: the conductor's.
class RecordWatch final {
 public:
  static constexpr double kHealth_s = 2.0;

  /// `monitor` may be null: then only buttons and the hand are observed.
  explicit RecordWatch(SessionMonitor* monitor) : monitor_(monitor) {}

  /// Times are on the session's clock, in order. The record is given as it is recorded
  /// (`as_recorded`), so that displays agree with the recording.
  void take(const TickRecord& record);
  /// Begins an attempt and resets its counts.
  void begin_attempt(const HandBands& bands) { hand_ = HandWatch(bands); }
  const HandWatch& hand() const noexcept { return hand_; }

  std::vector<ButtonChange> take_button_changes();
  /// All measures except the lost records, which are not passed to this class.
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
  HandWatch hand_{};
};

}  // namespace asperity
