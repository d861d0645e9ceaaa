// Sees every tick of a session go by: what a monitor shows of them, and the device's buttons.

#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "analysis/compliance.h"
#include "app/conductor/contact_reader.h"
#include "app/conductor/respondent.h"
#include "app/conductor/session_monitor.h"
#include "app/conductor/sound.h"
#include "renderers/tick_record.h"

namespace asperity {

/// What is asked of force and speed.
struct HandBands {
  AskedBand normal_force_N{};
  AskedBand speed_m_per_s{};
};

/// Makes the monitor's bins of 1/60 s, knows how the loop has kept time in the last two seconds, and
/// notices when a button of the device goes down or up. Within attempts and between them. Within one it
/// counts how force and speed meet their bands, with the samples that the attempt will be judged by.
///
/// Threads: the conductor's.
class RecordWatch final {
 public:
  static constexpr double kHealth_s = 2.0;

  /// `monitor` may be null: then only buttons are noticed.
  explicit RecordWatch(SessionMonitor* monitor) : monitor_(monitor) {}

  /// Times on the session's clock, in order. As it is recorded (`as_recorded`), so that what is shown
  /// is what the recording gives.
  void take(const TickRecord& record);
  /// An attempt begins: what was counted before is of another.
  void begin_attempt(const HandBands& bands);
  /// Of the surface that was presented last in the attempt, all its visits together.
  HandSoFar hand() const;
  /// What the hand is to be told now: of the force before the speed. Nothing without contact, nor while
  /// the hand turns; one that rests longer is to move.
  GuideTone tone() const;
  static constexpr double kTurn_s = 0.5;

  std::vector<ButtonChange> take_button_changes();
  /// All but the lost records, which nobody sees go by.
  LoopHealth health() const;

 private:
  struct Tick {
    std::int64_t time_ns = 0;
    std::int32_t lateness_ns = 0;
  };
  /// Mean and spread as they grow, and how many samples lay in the band.
  struct Tally {
    std::int64_t samples = 0;
    std::int64_t inside = 0;
    double mean = 0.0;
    double squares = 0.0;  ///< Σ(x − mean)²
    void add(double sample, const AskedBand& band) noexcept;
    QuantitySoFar so_far(const AskedBand& band) const;
  };
  struct HandTally {
    Tally force_N{};
    Tally speed_m_per_s{};
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
  ContactReader reader_{};
  HandBands bands_{};
  std::uint64_t presented_ = 0;  ///< in this attempt; 0: none yet
  std::map<std::uint64_t, HandTally> tallies_{};
  std::optional<HandSample> now_{};  ///< of the last tick
  std::int64_t last_ns_ = 0;
  std::int64_t stroked_ns_ = 0;  ///< when the hand last stroked, or touched after a lift
};

}  // namespace asperity
