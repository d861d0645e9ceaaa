// Judges from outside of the servo thread whether the ticks of a loop still return.

#include "renderers/servo/tick_watch.h"

namespace asperity {

TickWatch::Verdict TickWatch::look(const TickProgress& seen, std::int64_t now_ns) noexcept {
  if (!has_looked_ || seen.begun != last_.begun || seen.ended != last_.ended) {
    has_looked_ = true;
    last_ = seen;
    since_ns_ = now_ns;
    looks_ = 0;
    return Verdict::well;
  }
  ++looks_;
  const double standing_s = 1e-9 * static_cast<double>(now_ns - since_ns_);
  const bool is_in_tick = seen.begun != seen.ended;
  if (pacing_ == Pacing::theirs && !is_in_tick) {
    return standing_s > settings_.silence_to_fault_s ? Verdict::silent : Verdict::well;
  }
  const double looked_s = 1e-9 * static_cast<double>(kBetweenLooks_ns * looks_);
  const bool is_standing = seen.presenting
                               ? standing_s > settings_.standstill_to_fault_s
                               : looked_s > kWithoutSurface * settings_.standstill_to_fault_s;
  return is_standing ? Verdict::standing : Verdict::well;
}

}  // namespace asperity
