// The sections on presentation and exploration: missed deadlines, losses, and quantiles over the attempts.

#include <algorithm>
#include <set>
#include <utility>

#include "analysis/numbers/summary.h"
#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/display_number.h"
#include "app/report/text/report_sections.h"
#include "app/words/text_parts.h"
#include "renderers/servo/servo_loop.h"

namespace asperity {

namespace {

constexpr const char* kStepped = "stepped";  // by a simulated clock

using QualityRow = std::vector<std::string>;

/// The median over the attempts, and the maximum.
QualityRow time_row(const std::string& what, const std::vector<double>& values_s) {
  const std::optional<Summary> summary = summary_of(values_s);
  if (!summary) return {what, "–", "–"};
  return {what, display_quantity(summary->p50, "s"), display_quantity(summary->maximum, "s")};
}

std::uint64_t unsigned_count(std::int64_t count) {
  return count < 0 ? 0 : static_cast<std::uint64_t>(count);
}

QualityRow count_row(const std::string& what, const ReportedCount& count, const std::string& of) {
  return {what, display_count(unsigned_count(count.total)),
          display_count(count.affected) + " of " + display_count(count.of) + ' ' + of,
          display_count(unsigned_count(count.worst))};
}

/// "stroke length" for `stroke_length_m`.
std::string words_of_explored(const std::string& quantity) {
  const std::string words = words_of_parameter(quantity);
  return words == "contact" ? "time in contact" : words;
}

std::string band_text(const std::optional<double>& minimum, const std::optional<double>& maximum,
                      const std::string& unit) {
  if (minimum && maximum) {
    return display_quantity(*minimum, unit) + " to " + display_quantity(*maximum, unit);
  }
  if (minimum) return "at least " + display_quantity(*minimum, unit);
  if (maximum) return "at most " + display_quantity(*maximum, unit);
  return "none";
}

std::string times(const ReportedCount& count, const std::string& none, const std::string& one,
                  const std::string& some) {
  if (count.total == 0) return none;
  return display_count(unsigned_count(count.total)) + ' ' + (count.total == 1 ? one : some) +
         " in " + count_in_words(count.affected) + (count.affected == 1 ? " attempt" : " attempts");
}

/// " (one of them in contact)": of the missed deadlines, where there were any.
std::string in_contact_text(const ReportedServo& servo) {
  if (servo.missed_deadlines.total == 0) return {};
  const std::uint64_t missed = unsigned_count(servo.missed_in_contact.total);
  return " (" + (missed == 0 ? "none" : count_in_words(missed)) + " in contact)";
}

/// "12 ticks of one attempt"
std::string ticks_of(const ReportedCount& count) {
  return display_count(unsigned_count(count.total)) +
         (count.total == 1 ? " tick of " : " ticks of ") + count_in_words(count.affected) +
         (count.affected == 1 ? " attempt" : " attempts");
}

ReportText timing_text(const ReportFacts& facts) {
  std::set<std::string> pacings{};
  std::set<double> rates{};
  for (const ReportedSession& session : facts.sessions) {
    pacings.insert(session.row.pacing);
    rates.insert(session.row.rate_Hz);
  }
  std::vector<std::string> rate_texts{};
  for (const double rate : rates) rate_texts.push_back(display_number(rate));
  std::string text =
      "The servo loop was set to " + listed(rate_texts) + " Hz; it ran " +
      display_count(unsigned_count(facts.servo.ticks)) + " ticks in " +
      display_count(facts.servo.attempts) + (facts.servo.attempts == 1 ? " attempt" : " attempts") +
      (facts.other_kinds.empty()
           ? "."
           : ", " + listed({facts.other_kinds.begin(), facts.other_kinds.end()}) + " included.");
  if (pacings == std::set<std::string>{kStepped}) {
    return {text +
            " It was stepped on a simulated clock, where no tick can be late: its times do not "
            "describe a device."};
  }
  const std::optional<Summary> lateness = summary_of(facts.servo.lateness_p99_s);
  if (lateness) {
    text += " In the median attempt, 99 % of the ticks began at most " +
            display_quantity(lateness->p50, "s") + " late; in the worst attempt, " +
            display_quantity(lateness->maximum, "s") + '.';
  }
  if (pacings.contains(kStepped)) {
    text += " Some sessions were stepped on a simulated clock, where no tick can be late.";
  }
  return {text};
}

ReportText losses_text(const ReportFacts& facts) {
  const ReportedServo& servo = facts.servo;
  std::string text =
      capitalised(listed({times(servo.missed_deadlines, "no deadline was missed",
                                "deadline was missed", "deadlines were missed") +
                              in_contact_text(servo),
                          times(servo.lost_records, "every tick was recorded",
                                "tick was not recorded", "ticks were not recorded")}) +
                  ". ");
  std::vector<std::string> limited{};
  if (servo.saturated.total > 0) {
    limited.push_back("the limiter reduced the force in " + ticks_of(servo.saturated));
  }
  if (servo.slew_limited.total > 0) {
    limited.push_back("the limiter limited the growth of the force in " +
                      ticks_of(servo.slew_limited));
  }
  if (servo.not_finite.total > 0) {
    limited.push_back("a force that was not finite was set to zero in " +
                      ticks_of(servo.not_finite));
  }
  text +=
      limited.empty() ? "The force limiter was never active." : capitalised(listed(limited)) + '.';
  for (const auto& [fault, count] : servo.faults) {
    if (fault == name_of(Fault::emergency_stop)) {
      text += " The emergency stop was pressed in " + count_in_words(count) +
              (count == 1 ? " attempt." : " attempts.");
      continue;
    }
    std::string words = fault;
    std::replace(words.begin(), words.end(), '_', ' ');
    text += " In " + count_in_words(count) + (count == 1 ? " attempt" : " attempts") +
            " a fault stopped the forces: " + words + '.';
  }
  return {text};
}

ReportTable times_table(const ReportedServo& servo) {
  ReportTable table{};
  table.title = "Timing of the servo loop";
  table.columns = {{"measure", false}, {"median attempt", true}, {"worst attempt", true}};
  table.rows = {time_row("lateness, median", servo.lateness_p50_s),
                time_row("lateness, 99th percentile", servo.lateness_p99_s),
                time_row("lateness, maximum", servo.lateness_maximum_s),
                time_row("period, 99th percentile", servo.period_p99_s),
                time_row("duration of a tick, 99th percentile", servo.execution_p99_s)};
  table.note =
      "Lateness: delay of the start of a tick after its deadline. Each attempt has one value per "
      "row; the "
      "table shows the median and the largest of these values over the attempts.";
  return table;
}

ReportTable counts_table(const ReportFacts& facts) {
  const ReportedServo& servo = facts.servo;
  ReportTable table{};
  table.title = "Missed deadlines and changed forces";
  table.columns = {{"event", false},
                   {"ticks in total", true},
                   {"attempts affected", true},
                   {"maximum per attempt", true}};
  table.rows = {count_row("missed deadlines", servo.missed_deadlines, "attempts"),
                count_row("missed deadlines in contact", servo.missed_in_contact, "attempts"),
                count_row("gaps between ticks in contact", servo.gaps_in_contact, "attempts"),
                count_row("readings replaced as implausible", servo.held_readings, "attempts"),
                count_row("ticks missing from the recording", servo.lost_records, "attempts"),
                count_row("force reduced to the limit", servo.saturated, "attempts"),
                count_row("growth of the force limited", servo.slew_limited, "attempts"),
                count_row("force that was not finite", servo.not_finite, "attempts")};
  for (const auto& [limit, count] : facts.limits) {
    const auto& [model, name, felt] = limit;
    std::string kind = name;
    std::replace(kind.begin(), kind.end(), '_', ' ');
    table.rows.push_back(count_row("violated assumption of " + model + ": " + kind + ", " + felt,
                                   count, "surfaces"));
  }
  // Counts of zero are already reported in the text.
  std::erase_if(table.rows, [](const QualityRow& row) { return row[1] == "0"; });
  return table;
}

}  // namespace

ReportSection presentation_section(const ReportFacts& facts) {
  ReportSection section{"Presentation", {}};
  if (facts.servo.attempts == 0) {
    section.parts.emplace_back(ReportText{"No timing of the servo loop is stored."});
    return section;
  }
  section.parts.emplace_back(timing_text(facts));
  section.parts.emplace_back(losses_text(facts));
  const bool is_timed =
      std::any_of(facts.sessions.begin(), facts.sessions.end(),
                  [](const ReportedSession& session) { return session.row.pacing != kStepped; });
  if (is_timed) section.parts.emplace_back(times_table(facts.servo));
  ReportTable counts = counts_table(facts);
  if (!counts.rows.empty()) section.parts.emplace_back(std::move(counts));
  return section;
}

namespace {

constexpr const char* kNoFractionRequired =
    "The protocol requires no minimum proportion of the contact time or of the strokes to be "
    "within these bands.";

/// Which hand explored, and how its force was measured on a device without motors.
std::string explored_by_text(const ReportFacts& facts) {
  if (facts.group == AnswerGroup::virtual_participants) return {};
  std::string text{};
  if (const SessionShare held = share_of_sessions(facts, is_moved_by_program); held.is_any()) {
    text += " No participant made the strokes " + held.text_after_not() + '.';
  }
  if (const SessionShare computed = share_of_sessions(facts, gives_no_force); computed.is_any()) {
    text +=
        " The normal force was computed " + computed.text() + ", but not exerted by the device.";
  }
  return text;
}

}  // namespace

ReportSection exploration_section(const ReportFacts& facts) {
  ReportSection section{"Exploration", {}};
  ReportTable table{};
  table.title = "Exploration: requested and recorded";
  table.columns = {{"quantity", false},   {"requested", false}, {"surfaces", true}, {"mean", true},
                   {"5 % to 95 %", true}, {"in band", true},    {"passed", true}};
  std::vector<std::string> required{};
  std::vector<std::string> described{};
  bool has_limits = false;
  for (const auto& [key, band] : facts.bands) {
    const auto& [quantity, minimum, maximum] = key;
    const std::string words = words_of_explored(quantity);
    const std::string unit = unit_of_parameter(quantity);
    const std::optional<Summary> means = summary_of(band.means);
    const std::optional<Summary> fractions = summary_of(band.fractions);
    if (!means) continue;
    const bool judged = band.judged > 0;
    const bool is_limited = minimum || maximum;
    has_limits = has_limits || is_limited;
    table.rows.push_back(
        {words, band_text(minimum, maximum, unit), display_count(band.means.size()),
         display_quantity(means->mean, unit),
         display_quantity(means->p05, unit) + " to " + display_quantity(means->p95, unit),
         fractions && is_limited ? display_percent(fractions->mean) : "–",
         judged ? display_count(band.passed) + " of " + display_count(band.judged) : "–"});
    if (judged && is_limited) {
      const double share = static_cast<double>(band.passed) / static_cast<double>(band.judged);
      required.push_back(words + " (" + band_text(minimum, maximum, unit) + ") on " +
                         display_count(band.passed) + " of " + display_count(band.judged) +
                         (band.judged == 1 ? " surface (" : " surfaces (") +
                         display_percent(share) + ')');
    } else if (is_limited && fractions) {
      described.push_back(
          words + " was in its band (" + band_text(minimum, maximum, unit) + ") for " +
          display_percent(fractions->mean) +
          (quantity == "normal_force_N" ? " of the contact time" : " of the strokes"));
    }
  }
  if (table.rows.empty()) {
    section.parts.emplace_back(ReportText{"No measure of the exploration is stored."});
    return section;
  }
  std::string text =
      has_limits
          ? "The table shows what was recorded."
          : "The protocol sets no limits on the exploration; the table shows what was recorded.";
  if (!required.empty()) text = "Explored as the protocol requires: " + listed(required) + '.';
  if (!described.empty()) {
    text = (required.empty() ? "" : text + ' ') + std::string(kNoFractionRequired) +
           " On average, " + listed(described) + '.';
  }
  section.parts.emplace_back(ReportText{text + explored_by_text(facts)});
  table.note =
      "surfaces: number presented, over all attempts; mean: mean of the surfaces' means; 5 % to "
      "95 %: range of the middle 90 % of these means; in band: mean proportion within the band (of "
      "the contact time for the force, of the strokes for their speed and length); passed: number "
      "explored as required. Force: surfaces that were touched; speed and length: surfaces with a "
      "stroke.";
  section.parts.emplace_back(std::move(table));
  return section;
}

}  // namespace asperity
