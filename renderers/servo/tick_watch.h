// Declares the judgement, from outside of the servo thread, of whether the ticks of a loop still return.

#pragma once

#include <cstdint>

#include "renderers/servo/servo_loop.h"

namespace asperity {

/// Looks at the progress of a servo loop from another thread, every `kBetweenLooks_ns`, and states whether ticks come.
///
/// - Standing: a tick that is under way does not return, or, with a device that is paced, none begins, for longer than
///   ServoSettings::standstill_to_fault_s while a surface is presented. While none is presented there is no force, but a
///   session would wait for the tick for ever: the limit is then `kWithoutSurface` times as long, and is counted in looks, so
///   that the time in which the whole program was stopped does not count.
/// - Silent: a device that keeps time itself has begun no tick for longer than ServoSettings::silence_to_fault_s.
///
/// The time is that since the look that first saw the present progress: a verdict comes at most one interval between looks
/// after its limit, plus the time by which the looks themselves are late.
///
/// Threads: belongs to one.
class TickWatch final {
 public:
  static constexpr std::int64_t kBetweenLooks_ns = 5'000'000;
  static constexpr double kWithoutSurface = 20.0;

  enum class Verdict { well, silent, standing };

  TickWatch(const ServoSettings& settings, Pacing pacing) noexcept
      : settings_(settings), pacing_(pacing) {}

  Verdict look(const TickProgress& seen, std::int64_t now_ns) noexcept;

 private:
  ServoSettings settings_{};
  Pacing pacing_;
  TickProgress last_{};
  bool has_looked_ = false;
  std::int64_t since_ns_ = 0;  ///< the first look at `last_`
  std::int64_t looks_ = 0;     ///< after it
};

}  // namespace asperity
