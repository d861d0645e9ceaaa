// Counts down from the last estimate while the session runs, and adds the time of day of its end.

#include "app/gui/session/time_left.h"

#include <algorithm>

#include "app/gui/session/session_clock.h"
#include "app/gui/session/session_text.h"
#include "app/session/rig/clock.h"

namespace asperity {

void TimeLeft::take(const SessionSnapshot& snapshot) {
  if (snapshot.expected_left_s == expected_s_) return;
  expected_s_ = snapshot.expected_left_s;
  since_ns_ = snapshot.now_ns;
}

QString TimeLeft::text(const SessionSnapshot& snapshot, const SessionFacts* facts) {
  if (snapshot.phase == SessionPhase::ended) return {};
  // A simulated clock has its own rate: there, no time of day can be stated.
  if (!expected_s_ || facts == nullptr || facts->row.pacing != "real_time") {
    return SessionText::of_left(expected_s_, {});
  }
  const std::int64_t time_ns = now_ns(snapshot, facts);
  const bool stands_still =
      snapshot.phase == SessionPhase::paused || snapshot.phase == SessionPhase::fault;
  if (stands_still) since_ns_ = time_ns;
  const std::int64_t end_ns =
      std::max(time_ns, since_ns_ + static_cast<std::int64_t>(1e9 * *expected_s_));
  return SessionText::of_left(seconds_between(time_ns, end_ns),
                              text_of_clock(end_ns, snapshot, facts));
}

}  // namespace asperity
