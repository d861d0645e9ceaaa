// Matches each lasting event with the one that ends it, and assigns attempts by their times.

#include "app/records/session_timeline.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "app/words/event_kinds.h"

namespace asperity {

namespace {

bool is_ended_by(std::string_view open, std::string_view kind) {
  const EventKind* const known = event_kind(open);
  if (known == nullptr || known->ended_by.empty()) return false;
  return ends_session(kind) ||
         std::find(known->ended_by.begin(), known->ended_by.end(), kind) != known->ended_by.end();
}

bool lasts(std::string_view kind) {
  const EventKind* const known = event_kind(kind);
  return known != nullptr && !known->ended_by.empty();
}

/// The current attempt. A break that begins when an attempt ends is not part of it, nor one that
/// ends when the next begins.
const AttemptRow* attempt_at(const std::vector<AttemptRow>& attempts, std::int64_t time_ns) {
  const auto found =
      std::find_if(attempts.begin(), attempts.end(), [time_ns](const AttemptRow& attempt) {
        return attempt.onset_ns < time_ns && time_ns < attempt.offset_ns;
      });
  return found == attempts.end() ? nullptr : &*found;
}

}  // namespace

std::vector<TimedEvent> session_timeline(const std::vector<EventRow>& events,
                                         const std::vector<AttemptRow>& attempts) {
  std::vector<TimedEvent> timeline{};
  for (const EventRow& row : events) {
    timeline.push_back({.row = row, .attempt = attempt_at(attempts, row.time_ns)});
  }
  for (const AttemptRow& attempt : attempts) {
    for (const EventRow& row : attempt.events) {
      timeline.push_back({.row = row, .attempt = &attempt});
    }
  }
  std::stable_sort(timeline.begin(), timeline.end(), [](const TimedEvent& a, const TimedEvent& b) {
    return a.row.time_ns < b.row.time_ns;
  });
  std::vector<TimedEvent*> open{};
  for (TimedEvent& event : timeline) {
    event.number = static_cast<int>(&event - timeline.data()) + 1;
    // Events that were open when the program crashed have no recorded end.
    if (event.row.kind == "session_resumed") open.clear();
    std::erase_if(open, [&event](TimedEvent* begun) {
      if (!is_ended_by(begun->row.kind, event.row.kind)) return false;
      begun->duration_s = static_cast<double>(event.row.time_ns - begun->row.time_ns) * 1e-9;
      return true;
    });
    if (lasts(event.row.kind)) {
      open.push_back(&event);
    } else {
      event.duration_s = 0.0;
    }
  }
  return timeline;
}

}  // namespace asperity
