// Computes the age of a session from its stored events, and compares it with the protocol's maximum.

#include "app/tasks/unfinished_session.h"

#include <algorithm>
#include <exception>
#include <set>

#include <nlohmann/json.hpp>

#include "analysis/numbers/number_text.h"
#include "app/session/levels/external_program.h"
#include "app/session/rig/clock.h"
#include "app/session/session_setup.h"
#include "app/words/time_ago.h"
#include "app/words/utc_time.h"

namespace asperity {

std::int64_t last_time_ns(const Study& study, const SessionRow& session) {
  std::int64_t last_ns = session.clock_zero_ns;
  for (const AttemptRow& attempt : study.attempts(session.id)) {
    last_ns = std::max(last_ns, attempt.offset_ns);
  }
  for (const EventRow& event : study.events(session.id)) {
    last_ns = std::max(last_ns, event.time_ns);
  }
  return last_ns;
}

double hours_since_it_ran(const Study& study, const SessionRow& session) {
  const std::string now_utc = SystemClock(0).utc();
  if (session.ended_utc) {
    return kHoursADay * (days_since_1970(now_utc) - days_since_1970(*session.ended_utc));
  }
  // The session was interrupted. Its clock corresponds to the time of day only within a stretch.
  std::string began_utc = session.started_utc;
  std::int64_t began_ns = session.clock_zero_ns;
  for (const EventRow& event : study.events(session.id)) {
    if (event.kind != "session_began" && event.kind != "session_resumed") continue;
    const auto data = nlohmann::json::parse(event.data_json, nullptr, false);
    if (!data.is_object() || !data.contains("utc") || !data["utc"].is_string()) continue;
    began_utc = data["utc"].get<std::string>();
    began_ns = event.time_ns;
  }
  const double ran_hours = seconds_between(began_ns, last_time_ns(study, session)) / 3600.0;
  return kHoursADay * (days_since_1970(now_utc) - days_since_1970(began_utc)) - ran_hours;
}

std::optional<LateResume> late_resume(const Study& study, const Protocol& protocol,
                                      const SessionRow& session) {
  const std::optional<double>& maximum = protocol.resume.maximum_age_hours;
  if (!maximum || session.pacing == "stepped") return {};
  const double age_hours = hours_since_it_ran(study, session);
  if (age_hours <= *maximum) return {};
  return LateResume{.age_hours = age_hours, .maximum_age_hours = *maximum};
}

Phrase complaint_about(const LateResume& late) {
  // With a decimal where it can be close to the maximum.
  constexpr double kTwoDays_h = 48.0;
  const Phrase age = late.age_hours < kTwoDays_h
                         ? phrase("TimeAgo", "%1 hours ago").with(fixed(late.age_hours, 1))
                         : time_ago(late.age_hours);
  return phrase("UnfinishedSession",
                "the session last ran %1, but the protocol requires sessions to be resumed within "
                "%2 h")
      .with(age, number_text(late.maximum_age_hours));
}

namespace {

bool lacks_levels(const Study& study, const Protocol& protocol, const SessionRow& row) {
  if (blocks_of_external_program(protocol).empty()) return false;
  try {
    return !reopen(study, protocol, row).course->is_complete();
  } catch (const std::exception&) {
    return true;  // it cannot be resumed, which is stated when this is attempted
  }
}

}  // namespace

std::vector<UnfinishedSession> unfinished_sessions(const Study& study, const Protocol& protocol) {
  std::set<std::int64_t> ids{};  // of the sessions with this text
  for (const ProtocolRow& row : study.protocols()) {
    if (row.source == protocol.source) ids.insert(row.id);
  }
  std::vector<UnfinishedSession> sessions{};
  for (const SessionRow& row : study.sessions()) {
    if (row.state == SessionState::completed || row.withdrawn || !ids.contains(row.protocol_id)) {
      continue;
    }
    if (has_ended_by_rule(study, protocol, row)) continue;
    const SessionCounts counts = study.session_counts(row.id);
    sessions.push_back({.row = row,
                        .trials_done = counts.done_trials,
                        .trials = counts.planned_trials,
                        .late = late_resume(study, protocol, row),
                        .noise = recorded_stretches(row, study.events(row.id), {}).back().noise,
                        .lacks_levels = lacks_levels(study, protocol, row)});
  }
  return sessions;
}

std::optional<UnfinishedSession> unfinished_of(const std::vector<UnfinishedSession>& sessions,
                                               const std::string& participant,
                                               std::optional<std::int64_t> id) {
  std::optional<UnfinishedSession> found{};
  for (const UnfinishedSession& session : sessions) {
    if (session.row.participant == participant && (!id || session.row.id == *id)) found = session;
  }
  return found;
}

}  // namespace asperity
