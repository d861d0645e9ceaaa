// What each tick of a contact says of the hand: what attempts are judged by and windows show.

#pragma once

#include <cstdint>
#include <optional>

#include "analysis/compliance.h"
#include "renderers/tick_record.h"

namespace asperity {

/// The hand in one tick in which it touches a surface.
struct HandSample {
  std::uint64_t presentation = 0;
  double pressing_N = 0.0;     ///< the normal force that was sent, as PressingForce has it
  double speed_m_per_s = 0.0;  ///< along the surface
  bool is_stroking = false;    ///< fast enough for a stroke: a turn of the hand is none
};

/// Reads records one after another. Whoever reads the same records has the same samples to the bit,
/// so that what is shown of a hand and what is computed of its recording later agree: give it records
/// as they are recorded (`as_recorded`).
class ContactReader final {
 public:
  /// Slower than this a hand turns or rests; bands of speed are asked for along a stroke.
  static constexpr double kStroking_m_per_s = 0.010;

  /// Nothing while no surface is touched.
  std::optional<HandSample> take(const TickRecord& record) noexcept;

 private:
  PressingForce pressing_{};
  std::uint64_t presentation_ = 0;
  std::int64_t last_ns_ = 0;
};

}  // namespace asperity
