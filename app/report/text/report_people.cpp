// The sections on participants and on exclusions: counts of sessions and attempts, with the reasons of those that do not count.

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <nlohmann/json.hpp>

#include "analysis/numbers/number_text.h"
#include "analysis/numbers/summary.h"
#include "app/findings/outcome/display_number.h"
#include "app/report/text/report_order.h"
#include "app/report/text/report_sections.h"
#include "app/words/coded_phrases.h"
#include "app/words/text_parts.h"
#include "results_schema/stored_json.h"

namespace asperity {

namespace {

/// "10 female", without participants for whom nothing is stored; empty where this applies to all.
std::string counts_of(const std::map<std::string, std::size_t>& counts,
                      const std::vector<std::pair<std::string, std::string>>& words,
                      std::size_t told, std::size_t all) {
  std::vector<std::string> parts{};
  for (const auto& [stored, shown] : words) {
    const auto found = counts.find(stored);
    if (found != counts.end()) parts.push_back(display_count(found->second) + ' ' + shown);
  }
  if (told < all) parts.push_back(display_count(all - told) + " not reported");
  return listed(parts);
}

std::string ages_text(const ReportFacts& facts) {
  std::vector<double> ages{};
  for (const ParticipantRow& person : facts.participants) {
    if (person.age_years) ages.push_back(*person.age_years);
  }
  const std::optional<Summary> summary = summary_of(ages);
  if (!summary) return {};
  std::string text{};
  if (summary->n == 1) {
    text = display_number(summary->mean) + " years";
  } else {
    text = "M = " + fixed(summary->mean, 1) + " years, SD = " + fixed(summary->sd, 1) + ", range " +
           display_number(summary->minimum) + " to " + display_number(summary->maximum);
  }
  if (summary->n < facts.participants.size()) {
    text += " (" + display_count(summary->n) + " of " + display_count(facts.participants.size()) +
            " reported)";
  }
  return text;
}

/// The decision by which a session is excluded, if any.
std::optional<DecisionRow> exclusion_of(const ReportedSession& session) {
  std::optional<DecisionRow> standing{};
  for (const DecisionRow& decision : session.decisions) {
    if (decision.trial) continue;
    if (decision.verdict == Verdict::exclude) standing = decision;
    if (decision.verdict == Verdict::include) standing.reset();
  }
  return standing;
}

std::string reported_session_name(const ReportedSession& session) {
  return "session " + std::to_string(session.row.session) + " of " + session.row.participant;
}

std::string state_text(const ReportedSession& session) {
  const std::string trials =
      done_trials_text(session) + (session.planned_trials == 1 ? " trial" : " trials");
  const std::string done = " after " + trials;
  if (session.is_running) return "is running (" + trials + " done)";
  switch (session.row.state) {
    case SessionState::open:
      return "was left open" + done;
    case SessionState::completed:
      return "was completed";
    case SessionState::stopped:
      return "was stopped" + done;
    case SessionState::crashed:
      return "was interrupted" + done;
  }
  return {};
}

/// That participants did not move a device, where this is the case.
std::string hands_text(const ReportFacts& facts) {
  const SessionShare held = share_of_sessions(facts, is_moved_by_program);
  if (!held.is_any()) return {};
  return " " + capitalised(held.text()) + " the program moved the device, not the " +
         (facts.participants.size() == 1 ? "participant." : "participants.");
}

/// The text for an outcome of attempts that do not count.
std::string fate_text(const std::string& fate) {
  static const std::map<std::string, std::string> kWords{
      {"aborted", "interrupted"},
      {"device_fault", "stopped by a fault"},
      {"emergency_stop", "ended by the emergency stop"},
      {"excluded", "excluded"},
      {"not_compliant", "not explored as instructed"},
      {"skipped", "skipped"},
      {"timed_out", "not answered in time"}};
  const auto found = kWords.find(fate);
  return found == kWords.end() ? fate : found->second;
}

std::string reason_text(const std::string& reason) {
  return reason.empty() ? "no reason stored" : reason;
}

ReportTable fates_table(const ReportFacts& facts) {
  ReportTable table{};
  table.title = "Attempts of the main phase that do not count, and flagged attempts that count";
  table.columns = {{"attempts", true}, {"outcome", false}, {"reason", false}};
  const auto add = [&table](const std::string& fate, const ReasonCounts& reasons) {
    std::vector<std::pair<std::string, std::size_t>> by_count(reasons.begin(), reasons.end());
    std::stable_sort(by_count.begin(), by_count.end(),
                     [](const auto& a, const auto& b) { return a.second > b.second; });
    for (const auto& [reason, count] : by_count) {
      table.rows.push_back({display_count(count), fate, reason_text(reason)});
    }
  };
  for (const auto& [fate, reasons] : facts.not_counted) add(fate_text(fate), reasons);
  add("flagged, counts", facts.flagged);
  return table;
}

std::size_t sum_of(const ReasonCounts& reasons) {
  std::size_t sum = 0;
  for (const auto& [reason, count] : reasons) sum += count;
  return sum;
}

/// ", none of which was completed"; for one session ", which was not completed"; and the number of
/// running sessions.
std::string completed_text(std::size_t completed, std::size_t running, std::size_t sessions) {
  if (sessions == 1) {
    return completed == 1 ? ", which was completed"
           : running == 1 ? ", which is running"
                          : ", which was not completed";
  }
  if (completed == sessions) {
    return sessions == 2 ? ", both of which were completed" : ", all of which were completed";
  }
  const std::string still = running == 0 ? ""
                                         : ", and " + count_in_words(running) + " of which " +
                                               (running == 1 ? "is" : "are") + " running";
  if (completed == 0) {
    return (sessions == 2 ? ", neither of which was completed" : ", none of which was completed") +
           still;
  }
  return ", " + count_in_words(completed) + " of which " +
         (completed == 1 ? "was completed" : "were completed") + still;
}

ReportText sessions_text(const ReportFacts& facts) {
  const auto completed = static_cast<std::size_t>(std::count_if(
      facts.sessions.begin(), facts.sessions.end(),
      [](const ReportedSession& each) { return each.row.state == SessionState::completed; }));
  const auto running = static_cast<std::size_t>(
      std::count_if(facts.sessions.begin(), facts.sessions.end(),
                    [](const ReportedSession& each) { return each.is_running; }));
  return {capitalised(participants_text(facts.group, facts.participants.size())) + " began " +
          count_in_words(facts.sessions.size()) +
          (facts.sessions.size() == 1 ? " session" : " sessions") +
          completed_text(completed, running, facts.sessions.size()) + '.'};
}

/// "; 2 count"; for one attempt "; it counts".
std::string counted_text(std::size_t counted, std::size_t attempts) {
  if (attempts == 1) return counted == 1 ? "; it counts" : "; it does not count";
  if (counted == attempts) return attempts == 2 ? "; both count" : "; all count";
  if (counted == 0) return attempts == 2 ? "; neither counts" : "; none counts";
  return "; " + display_count(counted) + (counted == 1 ? " counts" : " count");
}

/// " Four of them are practice trials that were repeated when two sessions were resumed."
std::string refreshers_text(const ReportFacts& facts) {
  if (facts.refreshers == 0) return {};
  const std::size_t sessions = facts.refreshed_sessions.size();
  return ' ' + capitalised(count_in_words(facts.refreshers)) +
         (facts.refreshers == 1 ? " of them is a practice trial that was repeated when "
                                : " of them are practice trials that were repeated when ") +
         count_in_words(sessions) +
         (sessions == 1 ? " session was resumed." : " sessions were resumed.");
}

/// " Two attempts belong to practice and are not included in the results."
std::string other_attempts_text(const ReportFacts& facts) {
  if (facts.other_attempts == 0) return {};
  return ' ' + capitalised(count_in_words(facts.other_attempts)) +
         (facts.other_attempts == 1 ? " attempt belongs to " : " attempts belong to ") +
         listed({facts.other_kinds.begin(), facts.other_kinds.end()}) +
         (facts.other_attempts == 1 ? " and is not included in the results"
                                    : " and are not included in the results") +
         (facts.other_kinds.contains(kCatchTrialsKind) ? "; catch trials have a separate table."
                                                       : ".") +
         refreshers_text(facts);
}

ReportText attempts_text(const ReportFacts& facts) {
  if (facts.attempts == 0) {
    return {"No attempt at a trial of the main phase is stored." + other_attempts_text(facts)};
  }
  std::string text = display_count(facts.attempts) +
                     (facts.attempts == 1 ? " attempt at a trial of the main phase is stored"
                                          : " attempts at trials of the main phase are stored") +
                     counted_text(facts.counted, facts.attempts) + '.';
  const std::vector<std::string> fates = fates_of_attempts(facts);
  if (!fates.empty()) text += " Not counted: " + listed(fates) + '.';
  const std::size_t flagged = sum_of(facts.flagged);
  if (flagged > 0) {
    text +=
        ' ' + capitalised(count_in_words(flagged)) +
        (flagged == 1 ? " attempt that counts is flagged." : " attempts that count are flagged.");
  }
  return {text + other_attempts_text(facts)};
}

}  // namespace

std::vector<std::string> fates_of_attempts(const ReportFacts& facts) {
  std::vector<std::string> fates{};
  for (const auto& [fate, reasons] : facts.not_counted) {
    const std::size_t count = sum_of(reasons);
    fates.push_back(count_in_words(count) + (count == 1 ? " was " : " were ") + fate_text(fate));
  }
  return fates;
}

std::string participants_text(AnswerGroup group, std::size_t count) {
  const std::string number = count_in_words(count);
  if (group == AnswerGroup::virtual_participants) {
    return number + (count == 1 ? " virtual participant" : " virtual participants");
  }
  return number + (count == 1 ? " participant" : " participants");
}

std::string capitalised(std::string text) {
  if (!text.empty() && text.front() >= 'a' && text.front() <= 'z') {
    text.front() = static_cast<char>(text.front() - 'a' + 'A');
  }
  return text;
}

std::string stopped(std::string text) {
  if (!text.ends_with('.')) text += '.';
  return text;
}

SampleTexts sample_texts(const ReportFacts& facts) {
  std::map<std::string, std::size_t> sexes{};
  std::map<std::string, std::size_t> hands{};
  for (const ParticipantRow& person : facts.participants) {
    if (person.sex) ++sexes[*person.sex];
    if (person.handedness) ++hands[*person.handedness];
  }
  const auto counted = [all = facts.participants.size()](
                           const std::map<std::string, std::size_t>& counts,
                           const std::vector<std::pair<std::string, std::string>>& words) {
    std::size_t sum = 0;
    for (const auto& [answer, count] : counts) sum += count;
    return counts.empty() ? std::string() : counts_of(counts, words, sum, all);
  };
  return {.sexes = counted(sexes, {{"F", "female"}, {"M", "male"}, {"X", "neither"}}),
          .ages = ages_text(facts),
          .hands = counted(hands, {{"right", "right-handed"},
                                   {"left", "left-handed"},
                                   {"ambidextrous", "ambidextrous"}})};
}

ReportSection participants_section(const ReportFacts& facts) {
  ReportSection section{"Participants", {}};
  const std::size_t all = facts.participants.size();
  std::string text{};
  const std::string who = capitalised(participants_text(facts.group, all));
  switch (facts.group) {
    case AnswerGroup::people:
      text = who + " took part." + hands_text(facts);
      break;
    case AnswerGroup::pilot:
      text = who + " took part in pilot sessions." + hands_text(facts);
      break;
    case AnswerGroup::virtual_participants:
      text = who + (all == 1 ? " was" : " were") +
             " simulated by a virtual hand and a virtual observer. No human participant took "
             "part.";
      break;
  }
  const SampleTexts sample = sample_texts(facts);
  text += sample.sexes.empty() ? " Sex is not stored." : " Sex: " + sample.sexes + '.';
  text += sample.ages.empty() ? " Age is not stored." : " Age: " + sample.ages + '.';
  text +=
      sample.hands.empty() ? " Handedness is not stored." : " Handedness: " + sample.hands + '.';
  section.parts.emplace_back(ReportText{text});
  if (const std::string groups = groups_text(facts); !groups.empty()) {
    section.parts.emplace_back(ReportText{groups});
  }

  if (facts.group != AnswerGroup::virtual_participants) {
    std::set<std::string> versions{};
    std::set<std::string> without{};
    std::size_t consented = 0;
    for (const ReportedSession& session : facts.sessions) {
      if (session.row.consent_version) {
        versions.insert(*session.row.consent_version);
        ++consented;
      } else {
        without.insert(session.row.participant);
      }
    }
    if (!versions.empty()) {
      section.parts.emplace_back(
          ReportText{"Consent to the protocol’s statement (version " +
                     listed({versions.begin(), versions.end()}) + ") was obtained beforehand " +
                     SessionShare{.whole = consented, .all = facts.sessions.size()}.text() + '.'});
    }
    if (!without.empty()) {
      section.parts.emplace_back(
          ReportText{"No consent is stored for " + listed({without.begin(), without.end()}) + '.',
                     ReportText::Tone::notice});
    }
  }
  return section;
}

/// "Session 1 of P001 was resumed 30.5 h after it had last run (the protocol allows at most 24 h): was ill."
std::string late_text(const ReportedSession& session, const EventRow& event) {
  const auto data = nlohmann::json::parse(event.data_json, nullptr, false);
  const auto hours = [&data](const char* key) {
    return data.is_object() ? data.value(key, 0.0) : 0.0;
  };
  return stopped(capitalised(reported_session_name(session)) + " was resumed " +
                 fixed(hours("age_hours"), 1) +
                 " h after it had last run (the protocol allows at most " +
                 display_number(hours("maximum_age_hours")) + " h): " + phrase_of(event).english());
}

ReportText withdrawals_text(std::span<const WithdrawalRow> withdrawals) {
  static const std::map<WithdrawalReason, std::string> kWords{
      {WithdrawalReason::consent_withdrawn, "consent withdrawn"},
      {WithdrawalReason::not_eligible, "not eligible"},
      {WithdrawalReason::other, "other reasons"}};
  std::map<std::string, std::size_t> counts{};
  std::size_t deleted = 0;
  for (const WithdrawalRow& row : withdrawals) {
    ++counts[kWords.at(row.reason)];
    if (row.data == WithdrawnData::deleted) ++deleted;
  }
  std::vector<std::string> reasons{};
  for (const auto& [reason, count] : counts) {
    reasons.push_back(reason + (counts.size() > 1 ? " " + display_count(count) : ""));
  }
  const std::size_t count = withdrawals.size();
  const std::string data = deleted == count ? "deleted"
                           : deleted == 0   ? "kept"
                                            : "deleted for " + display_count(deleted) + " of them";
  return {"In the whole study, " + count_in_words(count) +
          (count == 1 ? " participant was" : " participants were") + " withdrawn (" +
          listed(reasons) + "); the data were " + data + " and are not included in this report."};
}

/// "staircase.py (SHA-256 9f86…, arguments: --fast)"
std::string program_text(const EventRow& event) {
  const auto data = stored_json(event.data_json, "event.data_json");
  std::vector<std::string> arguments{};
  for (const auto& argument : data.at("arguments")) {
    std::string text = argument.get<std::string>();
    const auto files = data.find("argument_sha256");
    if (files != data.end() && files->contains(text)) {
      text += " (SHA-256 " + files->at(text).get<std::string>() + ')';
    }
    arguments.push_back(std::move(text));
  }
  return data.at("program").get<std::string>() + " (SHA-256 " +
         data.at("sha256").get<std::string>() +
         (arguments.empty() ? std::string() : "; arguments: " + listed(arguments)) + ')';
}

std::string external_programs_text(const ReportFacts& facts) {
  std::map<std::string, std::size_t> sessions{};
  std::size_t failures = 0;
  for (const ReportedSession& session : facts.sessions) {
    std::set<std::string> own{};
    for (const EventRow& event : session.external_programs) own.insert(program_text(event));
    for (const std::string& program : own) ++sessions[program];
    failures += session.external_failures;
  }
  std::string text{};
  for (const auto& [program, count] : sessions) {
    text += (text.empty() ? "" : " ") + std::string("The external program ") + program +
            " stated levels in " + counted(count, "session", "sessions") + '.';
  }
  if (failures > 0) {
    text += (text.empty() ? "" : " ") + std::string("An external program failed ") +
            (failures == 1   ? std::string("once")
             : failures == 2 ? std::string("twice")
                             : count_in_words(failures) + " times") +
            '.';
  }
  return text;
}

ReportSection exclusions_section(const ReportFacts& facts) {
  ReportSection section{"Sessions and exclusions", {}};
  section.parts.emplace_back(sessions_text(facts));
  ReportList unfinished{};
  ReportList excluded{};
  for (const ReportedSession& session : facts.sessions) {
    if (session.row.state != SessionState::completed) {
      unfinished.items.push_back(capitalised(reported_session_name(session)) + ' ' +
                                 state_text(session) + '.');
    }
    if (const std::size_t times = session.resumed; times > 0) {
      unfinished.items.push_back(capitalised(reported_session_name(session)) +
                                 " was interrupted and resumed " +
                                 (times == 1   ? "once"
                                  : times == 2 ? "twice"
                                               : count_in_words(times) + " times") +
                                 '.');
    }
    for (const EventRow& event : session.late_resumes) {
      unfinished.items.push_back(late_text(session, event));
    }
    if (const std::optional<DecisionRow> decision = exclusion_of(session)) {
      const std::string by =
          decision->decided_by.empty() ? "" : " (decided by " + decision->decided_by + ')';
      excluded.items.push_back(stopped(capitalised(reported_session_name(session)) + ": " +
                                       phrase_of(decision->reason).english() + by));
    }
  }
  if (!unfinished.items.empty()) section.parts.emplace_back(std::move(unfinished));
  if (const std::string programs = external_programs_text(facts); !programs.empty()) {
    section.parts.emplace_back(ReportText{programs});
  }
  if (excluded.items.empty()) {
    section.parts.emplace_back(ReportText{"No session was excluded."});
  } else {
    const std::size_t count = excluded.items.size();
    section.parts.emplace_back(
        ReportText{capitalised(count_in_words(count)) +
                   (count == 1 ? " session was excluded:" : " sessions were excluded:")});
    section.parts.emplace_back(std::move(excluded));
  }
  if (!facts.withdrawals.empty()) section.parts.emplace_back(withdrawals_text(facts.withdrawals));
  section.parts.emplace_back(attempts_text(facts));
  ReportTable fates = fates_table(facts);
  if (!fates.rows.empty()) section.parts.emplace_back(std::move(fates));
  return section;
}

}  // namespace asperity
