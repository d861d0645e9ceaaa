// Takes the clock of the machine in real time and that of the snapshot otherwise, and adds the time of day.

#include "app/gui/session/session_clock.h"

#include <algorithm>
#include <chrono>

#include <QtCore/QDateTime>

namespace asperity {

std::int64_t now_ns(const SessionSnapshot& snapshot, const SessionFacts* facts) {
  const bool is_over = snapshot.phase == SessionPhase::ended;
  if (facts == nullptr || facts->row.pacing != "real_time" || is_over) return snapshot.now_ns;
  const std::int64_t machine_ns = std::chrono::duration_cast<std::chrono::nanoseconds>(
                                      std::chrono::steady_clock::now().time_since_epoch())
                                      .count();
  return std::max(snapshot.now_ns, machine_ns + facts->clock_ahead_ns);
}

QString text_of_clock(std::int64_t time_ns, const SessionSnapshot& snapshot,
                      const SessionFacts* facts) {
  const std::int64_t ahead_ns = time_ns - now_ns(snapshot, facts);
  return QDateTime::currentDateTime().addMSecs(ahead_ns / 1'000'000).toString("HH:mm");
}

}  // namespace asperity
