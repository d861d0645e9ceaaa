// Measures of the hand in each tick of a contact, by which attempts are judged and which windows
// show.

#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "analysis/signals/compliance.h"
#include "app/session/session_monitor.h"
#include "app/session/sound/sound.h"
#include "device/device_capability.h"
#include "renderers/servo/tick_record.h"

namespace asperity {

/// The force of a tick that measures how hard the hand presses: the one sent, which the hand
/// balances; for a device without motors, which is sent none, the one that the renderer computed.
enum class JudgedForce { sent, rendered };
JudgedForce judged_force_of(const DeviceCapability& device) noexcept;
/// "sent", "rendered": as stored with the session.
const char* text_of(JudgedForce force) noexcept;

/// The hand in one tick in which it touches a surface that is completely faded in.
struct HandSample {
  std::uint64_t presentation = 0;
  bool begins_contact = false;  ///< the hand had lifted before
  /// The mean of the judged normal force in this contact so far, weighted towards the last 0.2 s
  /// (PressingForce): how hard the hand presses, with little of a texture's ripple.
  double pressing_N = 0.0;
  double along_m = 0.0;  ///< the probe's position along the direction of the strokes
};

/// Reads records one after another. The same records give the same samples to the bit, so that
/// displays of a hand agree with later computations from its recording, provided that the records
/// are given as they are recorded (`as_recorded`).
///
/// While a surface fades in or out, the force that is sent does not measure the hand. A tool that
/// skips over a texture touches again within `kSkip_s` (contact.h) and has not lifted: the contact continues,
/// with zero force meanwhile.
class ContactReader final {
 public:
  /// `direction_rad` of the strokes, from +x towards +y.
  explicit ContactReader(double direction_rad = 0.0,
                         JudgedForce force = JudgedForce::sent) noexcept;

  /// Nothing in a tick without contact.
  std::optional<HandSample> take(const TickRecord& record) noexcept;
  /// Touches, or did within `kSkip_s` before the last record.
  bool is_in_contact() const noexcept { return in_contact_; }

 private:
  double along_x_ = 1.0;
  double along_y_ = 0.0;
  JudgedForce force_ = JudgedForce::sent;
  PressingForce pressing_{};
  std::uint64_t presentation_ = 0;
  bool in_contact_ = false;
  std::int64_t last_ns_ = 0;
  std::int64_t touched_ns_ = 0;
};

/// The instructed exploration.
struct HandBands {
  AskedBand normal_force_N{};
  AskedBand speed_m_per_s{};
  double direction_rad = 0.0;
  double usual_stroke_m = 0.0;  ///< see HandStrokes
  JudgedForce force = JudgedForce::sent;
};

/// Follows the hand through an attempt: counts how it meets its bands, with the samples by which
/// the attempt will be judged, and determines the tone that guides the hand.
///
/// Threads: the conductor's.
class HandWatch final {
 public:
  HandWatch() = default;
  /// Begins an attempt.
  explicit HandWatch(const HandBands& bands);

  void take(const TickRecord& record);
  /// The measures of the surface that was presented last in the attempt, over all its visits.
  HandSoFar so_far() const;

  /// The current measures: nothing while no surface is felt.
  struct Now {
    double pressing_N = 0.0;
    std::optional<double> stroking_m_per_s{};  ///< HandStrokes::speed_to_tell_m_per_s
  };
  const std::optional<Now>& now() const noexcept { return now_; }
  /// The force has precedence over the speed. A tone begins where a band is left, and ends
  /// `kBackInside` of the band's width (of the bound, where the other end is open) within it, so
  /// that a hand at the edge is guided by one tone at a time.
  GuideTone tone() const noexcept;
  static constexpr double kBackInside = 0.1;

 private:
  /// Running mean and spread, and the number of samples in the band.
  struct Tally {
    std::int64_t samples = 0;
    std::int64_t inside = 0;
    double mean = 0.0;
    double squares = 0.0;  ///< Σ(x − mean)²
    void add(double sample, const AskedBand& band) noexcept;
    QuantitySoFar so_far(const AskedBand& band) const;
  };
  struct Surface {
    Tally force_N{};
    HandStrokes strokes{};
  };
  enum class Side { below, inside, above };
  static Side side_of(const AskedBand& band, double value, Side before) noexcept;

  HandBands bands_{};
  ContactReader reader_{};
  std::uint64_t presented_ = 0;  ///< in this attempt; 0: none yet
  std::map<std::uint64_t, Surface> surfaces_{};
  std::optional<Now> now_{};
  Side force_ = Side::inside;
  Side speed_ = Side::inside;
};

}  // namespace asperity
