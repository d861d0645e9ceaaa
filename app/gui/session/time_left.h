// The expected remaining time of a session.

#pragma once

#include <cstdint>
#include <optional>

#include <QtCore/QString>

#include "app/session/session_monitor.h"

namespace asperity {

/// The conductor updates its expectation from trial to trial; between two updates the time runs down,
/// except while the session is paused or a fault is not cleared.
class TimeLeft final {
 public:
  void take(const SessionSnapshot& snapshot);
  /// Empty when the session has ended. `facts` may be null.
  QString text(const SessionSnapshot& snapshot, const SessionFacts* facts);

 private:
  std::optional<double> expected_s_{};
  std::int64_t since_ns_ = 0;  ///< when that was expected
};

}  // namespace asperity
