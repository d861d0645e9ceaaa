// Sees every tick of a session go by: what a monitor shows of them, and the device's buttons.

#pragma once

#include <cstdint>
#include <vector>

#include "app/session/respondents/respondent.h"
#include "app/session/rig/contact_reader.h"
#include "app/session/session_monitor.h"
#include "renderers/servo/tick_record.h"

namespace asperity {

/// Makes the monitor's bins of 1/60 s, knows how the loop has kept time in the last two seconds, and
/// notices when a button of the device goes down or up. Within attempts and between them. Within one it
/// follows the hand, too (HandWatch).
///
/// Threads: the conductor's.
class RecordWatch final {
 public:
  static constexpr double kHealth_s = 2.0;

  /// `monitor` may be null: then only buttons and the hand are noticed.
  explicit RecordWatch(SessionMonitor* monitor) : monitor_(monitor) {}

  /// Times on the session's clock, in order. As it is recorded (`as_recorded`), so that what is shown
  /// is what the recording gives.
  void take(const TickRecord& record);
  /// An attempt begins: what was counted before is of another.
  void begin_attempt(const HandBands& bands) { hand_ = HandWatch(bands); }
  const HandWatch& hand() const noexcept { return hand_; }

  std::vector<ButtonChange> take_button_changes();
  /// All but the lost records, which never pass here.
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
