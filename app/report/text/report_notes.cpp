// The section with the notes and decisions of the experimenter, by session and time.

#include <algorithm>
#include <cstdio>
#include <string>

#include "app/report/text/report_sections.h"
#include "app/words/coded_phrases.h"

namespace asperity {

namespace {

constexpr std::size_t kMostNotes = 500;

/// "12:05.3": minutes and seconds.
std::string clock_text(double time_s) {
  const bool is_before = time_s < 0.0;
  const auto tenths = static_cast<long long>((is_before ? -time_s : time_s) * 10.0 + 0.5);
  char text[32];
  std::snprintf(text, sizeof text, "%s%lld:%02lld.%lld", is_before ? "−" : "", tenths / 600,
                tenths / 10 % 60, tenths % 10);
  return text;
}

/// "trial repeated"
std::string what_text(std::string event_kind) {
  std::replace(event_kind.begin(), event_kind.end(), '_', ' ');
  return event_kind;
}

std::string decision_text(Verdict verdict) {
  switch (verdict) {
    case Verdict::flag:
      return "flagged afterwards";
    case Verdict::exclude:
      return "excluded afterwards";
    case Verdict::include:
      return "included again";
    case Verdict::set_aside:
      break;  // the time is that of the event "trial_repeated"
  }
  return {};
}

}  // namespace

ReportSection notes_section(const ReportFacts& facts) {
  ReportTable table{};
  table.is_reference = true;
  table.title = "The experimenter’s notes and decisions";
  table.columns = {{"participant", false}, {"session", true}, {"time (min:s)", true},
                   {"trial", true},        {"event", false},  {"note or reason", false}};
  std::size_t left_out = 0;
  const auto add = [&](std::vector<std::string> row) {
    if (table.rows.size() < kMostNotes) {
      table.rows.push_back(std::move(row));
    } else {
      ++left_out;
    }
  };
  for (const ReportedSession& session : facts.sessions) {
    const std::string& who = session.row.participant;
    const std::string number = std::to_string(session.row.session);
    for (const ReportedNote& note : session.notes) {
      add({who, number, clock_text(note.time_s), note.trial ? std::to_string(*note.trial) : "–",
           what_text(note.kind), note.text});
    }
    for (const DecisionRow& decision : session.decisions) {
      const std::string what = decision_text(decision.verdict);
      if (what.empty()) continue;
      const std::string by =
          decision.decided_by.empty() ? "" : " (decided by " + decision.decided_by + ')';
      add({who, number, "–", decision.trial ? std::to_string(*decision.trial) : "all", what,
           phrase_of(decision.reason).english() + by});
    }
  }
  ReportSection section{"Notes and decisions", {}};
  if (table.rows.empty()) return section;
  table.note =
      "Times are relative to the beginning of the session. The column trial contains the trial in "
      "progress, or – between trials and after the session.";
  if (left_out > 0) {
    table.note += " " + std::to_string(left_out) +
                  (left_out == 1 ? " further row is" : " further rows are") +
                  " in events.tsv of an export.";
  }
  section.parts.emplace_back(std::move(table));
  return section;
}

}  // namespace asperity
