// Rounds to hours, and from two days on to days.

#include "app/words/time_ago.h"

#include "analysis/numbers/number_text.h"

namespace asperity {

Phrase time_ago(double hours) {
  constexpr double kInHours = 2.0 * kHoursADay;
  if (hours < 1.0) return phrase("TimeAgo", "less than an hour ago");
  if (hours < 1.5) return phrase("TimeAgo", "an hour ago");
  if (hours < kInHours) return phrase("TimeAgo", "%1 hours ago").with(fixed(hours, 0));
  return phrase("TimeAgo", "%1 days ago").with(fixed(hours / kHoursADay, 0));
}

}  // namespace asperity
