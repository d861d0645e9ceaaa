// States when the participant had confirmed that the eye mask is on.

#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "app/records/session_timeline.h"
#include "results_schema/rows.h"

namespace asperity {

/// The confirmations of one session, in chronological order. The mask is off when a session begins or
/// is resumed.
class EyeMask final {
 public:
  explicit EyeMask(const std::vector<TimedEvent>& timeline);

  /// What was confirmed last, at or before this time.
  bool is_on(std::int64_t time_ns) const;
  /// Whether it was on at each visit to a surface; for a surface without visits, when it appeared.
  /// Nothing if no surface appeared.
  std::optional<bool> was_on_in(const AttemptRow& attempt) const;

 private:
  std::vector<std::pair<std::int64_t, bool>>
      changes_{};  ///< time in ns, and whether it is on since
};

}  // namespace asperity
