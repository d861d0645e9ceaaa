// The sections on how the data were made, for reference: programs, seeds and settings, and a row for each session.

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include <nlohmann/json.hpp>

#include "app/findings/outcome/display_number.h"
#include "app/report/text/report_order.h"
#include "app/report/text/report_sections.h"
#include "app/tasks/study_overview.h"

namespace asperity {

namespace {

/// Distinct values in the order of the sessions' keys, with the number of sessions of each where
/// they differ.
class Values final {
 public:
  void add(const std::string& value) {
    if (!value.empty()) ++sessions_[value];
  }
  std::string text() const {
    if (sessions_.empty()) return "not stored";
    if (sessions_.size() == 1) return sessions_.begin()->first;
    std::string text{};
    for (const auto& [value, sessions] : sessions_) {
      text += (text.empty() ? "" : "; ") + value + " (" + display_count(sessions) +
              (sessions == 1 ? " session)" : " sessions)");
    }
    return text;
  }

 private:
  std::map<std::string, std::size_t> sessions_{};
};

using TextOfStretch = std::function<std::string(const RecordedStretch&)>;

/// Distinct values, each with its sessions or parts of sessions where they differ.
std::string values_of_stretches(const ReportFacts& facts, const TextOfStretch& text_of) {
  std::set<std::string> values{};
  for (const ReportedSession& session : facts.sessions) {
    for (const RecordedStretch& stretch : session.stretches) values.insert(text_of(stretch));
  }
  if (values.size() == 1) return values.begin()->empty() ? "not stored" : *values.begin();
  std::string text{};
  for (const std::string& value : values) {
    const SessionShare share = share_of_sessions(
        facts, [&](const RecordedStretch& stretch) { return text_of(stretch) == value; });
    text += (text.empty() ? "" : "; ") + (value.empty() ? "not stored" : value) + " (" +
            share.text() + ')';
  }
  return text;
}

/// The first eight digits, as shown in windows.
std::string seed_text(const SessionRow& session) {
  return session.seed.empty() ? "–" : session.seed;
}

std::string began_text(const SessionRow& session) {
  if (has_made_up_dates(session)) return "simulated clock";
  return session.started_utc.substr(0, 16);
}

std::string with_blanks(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

std::string observer_text(const std::string& observer_json) {
  const nlohmann::json observer = nlohmann::json::parse(observer_json, nullptr, false);
  if (!observer.is_object()) return {};
  std::string text{};
  for (const auto& [name, value] : observer.items()) {
    const bool is_length = name.ends_with("_m");
    const std::string words = name == "deaf"
                                  ? "ignores the surface:"
                                  : with_blanks(name.substr(0, name.size() - (is_length ? 2 : 0)));
    text += (text.empty() ? "" : ", ") + words + ' ' +
            (value.is_string()                ? with_blanks(value.get<std::string>())
             : value.is_boolean()             ? (value.get<bool>() ? "yes" : "no")
             : is_length && value.is_number() ? display_quantity(value.get<double>(), "m")
                                              : value.dump());
  }
  return text;
}

}  // namespace

ReportSection making_section(const ReportFacts& facts) {
  ReportSection section{"Provenance", {}};
  Values rate{};
  Values generator{};
  Values observer{};
  std::map<std::string, std::string> files{};
  std::size_t mirrored = 0;
  for (const ReportedSession& session : facts.sessions) {
    const SessionRow& row = session.row;
    rate.add(display_number(row.rate_Hz) + " Hz");
    generator.add(row.generator);
    observer.add(observer_text(row.observer_json));
    if (row.mirrored) ++mirrored;
    for (const StimulusFileRow& file : row.files) files[file.path + ' ' + file.sha256] = file.path;
  }
  ReportTable table{};
  table.title = "Program, device and protocol";
  table.columns = {{"property", false}, {"value stored with the sessions", false}};
  const auto add = [&table](const std::string& what, const std::string& value) {
    table.rows.push_back({what, value});
  };
  using Stretch = RecordedStretch;
  const auto add_of_stretches = [&](const std::string& what, const TextOfStretch& text_of) {
    add(what, values_of_stretches(facts, text_of));
  };
  add_of_stretches("program", [](const Stretch& each) { return each.program.program; });
  add_of_stretches("instruction set",
                   [](const Stretch& each) { return each.program.instruction_set; });
  add_of_stretches("operating system", [](const Stretch& each) { return each.program.os; });
  add_of_stretches("device", [](const Stretch& each) { return each.device.text; });
  add_of_stretches("pacing", [](const Stretch& each) { return each.program.pacing; });
  const bool computes =
      std::any_of(facts.sessions.begin(), facts.sessions.end(), [](const ReportedSession& session) {
        return std::any_of(session.stretches.begin(), session.stretches.end(),
                           [](const Stretch& each) { return !each.program.compute.empty(); });
      });
  if (computes) {
    add_of_stretches("contacts evaluated by", [](const Stretch& each) {
      return each.program.compute.empty() ? std::string("the processor") : each.program.compute;
    });
  }
  add("rate of the servo loop", rate.text());
  add("random numbers", generator.text());
  add("protocol", facts.protocol.name + ' ' + facts.protocol.version);
  for (const std::string& sha256 : facts.sources) add("SHA-256 of the protocol’s file", sha256);
  for (const auto& [model, builds] : facts.plugin_builds) {
    for (const std::string& sha256 : builds) {
      const auto file = facts.plugin_files.find(sha256);
      const std::string name = file == facts.plugin_files.end() ? "" : ", file " + file->second;
      add("force model in a plug-in", model + name + ", SHA-256 " + sha256);
    }
  }
  if (facts.group == AnswerGroup::virtual_participants) add("virtual observer", observer.text());
  if (mirrored > 0) {
    add("left-handed layout", display_count(mirrored) + (mirrored == 1 ? " session" : " sessions") +
                                  " of " + display_count(facts.sessions.size()));
  }
  if (!files.empty()) {
    section.parts.emplace_back(ReportText{
        display_count(files.size()) +
        (files.size() == 1 ? " stimulus file belongs" : " stimulus files belong") +
        " to the protocol; sessions.tsv of an export contains the SHA-256 of each. The table of "
        "sessions lists the seed and the counterbalancing row of each session: together with the "
        "protocol, the files and the program, they determine its plan."});
  }
  section.parts.emplace_back(std::move(table));
  return section;
}

ReportSection sessions_section(const ReportFacts& facts) {
  ReportSection section{"Every session", {}};
  constexpr std::size_t kMostListed = 60;  // a page; more are in a separate table
  if (facts.sessions.size() > kMostListed) {
    section.parts.emplace_back(
        ReportText{display_count(facts.sessions.size()) +
                   " sessions do not fit on a page: sessions.tsv of an export lists each with its "
                   "dates, its state and its seed."});
    return section;
  }
  ReportTable table{};
  table.is_reference = true;
  table.title = "Sessions and their seeds";
  table.columns = {{"participant", false}, {"session", true},     {"began (UTC)", false},
                   {"state", false},       {"trials done", true}, {"counterbalancing row", true},
                   {"seed", true}};
  const bool has_groups =
      std::any_of(facts.sessions.begin(), facts.sessions.end(),
                  [](const ReportedSession& session) { return session.row.group_level; });
  if (has_groups) table.columns.push_back({"group", false});
  for (const ReportedSession& session : facts.sessions) {
    const SessionRow& row = session.row;
    std::string state = session.is_running ? "running" : text_of(row.state);
    if (row.excluded) state += ", excluded";
    table.rows.push_back({row.participant, std::to_string(row.session), began_text(row), state,
                          done_trials_text(session), std::to_string(row.counterbalance_row),
                          seed_text(row)});
    if (has_groups) table.rows.back().push_back(row.group_level.value_or("–"));
  }
  const bool ended_early =
      std::any_of(facts.sessions.begin(), facts.sessions.end(), [](const ReportedSession& session) {
        return session.row.state == SessionState::completed &&
               session.done_trials < session.planned_trials;
      });
  if (ended_early) {
    table.note =
        "A completed session has fewer trials than planned if a block reached its criterion before "
        "its last trial.";
  }
  section.parts.emplace_back(std::move(table));
  return section;
}

}  // namespace asperity
