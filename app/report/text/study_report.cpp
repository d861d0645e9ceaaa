// Makes a chapter for each protocol, version and group, from its facts and its analysis.

#include "app/report/text/study_report.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <span>
#include <utility>

#include "app/findings/outcome/display_number.h"
#include "app/findings/outcome/figures_of.h"
#include "app/findings/outcome/study_analysis.h"
#include "app/findings/study/analyze_study.h"
#include "app/report/text/figure_parts.h"
#include "app/report/text/report_parameters.h"
#include "app/report/text/report_sections.h"
#include "app/report/text/report_sexes.h"
#include "app/study_files/program.h"
#include "app/tasks/study_overview.h"

namespace asperity {

namespace {

// The proportion of a report's total time; the rest is a second pass over all responses.
constexpr double kFactsShare = 0.6;

std::string mark_of(AnswerGroup group) {
  switch (group) {
    case AnswerGroup::people:
      return {};
    case AnswerGroup::pilot:
      return "PILOT: not study data";
    case AnswerGroup::virtual_participants:
      return "SIMULATED: no human participant";
  }
  return {};
}

std::string group_text(AnswerGroup group) {
  switch (group) {
    case AnswerGroup::people:
      return "human participants";
    case AnswerGroup::pilot:
      return "human participants, pilot sessions";
    case AnswerGroup::virtual_participants:
      return "virtual participants";
  }
  return {};
}

std::string chapter_heading(const ReportFacts& facts) {
  return facts.protocol.name + ' ' + facts.protocol.version + ": " + group_text(facts.group);
}

/// "Data from 2026-03-02 to 2026-04-17 (UTC)". Sessions on a simulated clock have no date.
std::string dates_text(const std::vector<ReportFacts>& all, bool has_withdrawals) {
  std::set<std::string> days{};
  bool made_up = false;
  for (const ReportFacts& facts : all) {
    for (const ReportedSession& session : facts.sessions) {
      if (has_made_up_dates(session.row)) {
        made_up = true;
      } else {
        days.insert(session.row.started_utc.substr(0, 10));
      }
    }
  }
  if (days.empty() && made_up) return "Data from sessions on a simulated clock, which has no date";
  if (days.empty()) {
    return has_withdrawals ? "No data: all participants with sessions were withdrawn"
                           : "No data yet";
  }
  std::string text = days.size() == 1 ? "Data from " + *days.begin()
                                      : "Data from " + *days.begin() + " to " + *days.rbegin();
  return text +
         (made_up ? " (UTC), and from sessions on a simulated clock, which has no date" : " (UTC)");
}

ReportChapter overview_chapter(const std::vector<ReportFacts>& all,
                               const std::vector<WithdrawalRow>& withdrawals) {
  ReportChapter chapter{"Contents of the study", {}, AnswerGroup::people, {}};
  ReportSection& section = chapter.sections.emplace_back(ReportSection{"Overview", {}});
  if (all.empty()) {
    if (withdrawals.empty()) {
      section.parts.emplace_back(
          ReportText{"The study has no sessions yet: there are no results to report."});
      return chapter;
    }
    section.parts.emplace_back(ReportText{
        "All participants with sessions were withdrawn: there are no results to report."});
    section.parts.emplace_back(withdrawals_text(withdrawals));
    return chapter;
  }
  ReportTable table{};
  table.title = "Protocols and participants";
  table.columns = {{"protocol", false},    {"kind", false},           {"group", false},
                   {"participants", true}, {"sessions", true},        {"completed", true},
                   {"attempts", true},     {"attempts counted", true}};
  std::set<AnswerGroup> groups{};
  for (const ReportFacts& facts : all) {
    groups.insert(facts.group);
    const auto completed = std::count_if(facts.sessions.begin(), facts.sessions.end(),
                                         [](const ReportedSession& session) {
                                           return session.row.state == SessionState::completed;
                                         });
    table.rows.push_back({facts.protocol.name + ' ' + facts.protocol.version,
                          facts.protocol.kind + ", " + facts.protocol.design,
                          group_text(facts.group), display_count(facts.participants.size()),
                          display_count(facts.sessions.size()), std::to_string(completed),
                          display_count(facts.attempts), display_count(facts.counted)});
  }
  table.note = "Attempts are those of the main phase.";
  std::string text =
      all.size() == 1 ? "The study has one set of sessions; its heading indicates simulated data "
                        "and pilot sessions."
                      : "The study has " + count_in_words(all.size()) +
                            " sets of sessions, one for each version of a protocol and each group "
                            "of participants. They are never pooled: each has a separate chapter, "
                            "whose heading indicates simulated data and pilot sessions.";
  text += " Reference tables are in appendices at the end.";
  section.parts.emplace_back(ReportText{text});
  section.parts.emplace_back(std::move(table));
  if (groups.contains(AnswerGroup::virtual_participants)) {
    // The page names virtual participants, and is therefore marked as theirs, even if it also
    // includes people.
    chapter.group = AnswerGroup::virtual_participants;
    chapter.mark = groups.size() == 1 ? mark_of(chapter.group) : "includes SIMULATED data";
  } else if (groups.contains(AnswerGroup::pilot)) {
    chapter.group = AnswerGroup::pilot;
    chapter.mark = groups.size() == 1 ? mark_of(chapter.group) : "includes PILOT data";
  }
  return chapter;
}

/// The results of one kind of experiment.
struct ReportedOutcome {
  const AnalysisOutcome* outcome = nullptr;
  std::vector<Figure> figures{};
};

/// Those of a chapter, that of the protocol's own kind first.
std::vector<ReportedOutcome> outcomes_of(const std::vector<AnalysisOutcome>& outcomes,
                                         const ReportFacts& facts) {
  std::vector<ReportedOutcome> reported{};
  for (const AnalysisOutcome& outcome : outcomes) {
    if (outcome.protocol != facts.protocol.name || outcome.version != facts.protocol.version ||
        outcome.group != facts.group) {
      continue;
    }
    ReportedOutcome one{.outcome = &outcome};
    for (const Figure& figure : figures_of(outcome)) {
      std::vector<Figure> parts = parts_of_rows(figure);
      std::move(parts.begin(), parts.end(), std::back_inserter(one.figures));
    }
    reported.push_back(std::move(one));
  }
  std::stable_partition(reported.begin(), reported.end(), [&facts](const ReportedOutcome& each) {
    return each.outcome->kind == facts.protocol.kind;
  });
  return reported;
}

/// A section about one kind names it where the chapter has several.
ReportSection of_kind(ReportSection section, const ReportedOutcome& of,
                      const std::vector<ReportedOutcome>& all) {
  if (all.size() > 1) section.heading += " (" + name_of_kind(of.outcome->kind) + ")";
  return section;
}

/// The experimenter who runs a session is blind.
bool is_held_back(const ReportFacts& facts) {
  return facts.group == AnswerGroup::people && facts.is_running();
}

ReportChapter appendix_of(const ReportFacts& facts, const std::vector<ReportedOutcome>& outcomes) {
  ReportChapter chapter{
      "Appendix to " + chapter_heading(facts), mark_of(facts.group), facts.group, {}};
  for (const ReportedOutcome& each : outcomes) {
    if (is_held_back(facts)) break;
    ReportSection tables = tables_section(*each.outcome, each.figures);
    if (!tables.parts.empty()) {
      chapter.sections.push_back(of_kind(std::move(tables), each, outcomes));
    }
    chapter.sections.push_back(of_kind(numbers_section(*each.outcome), each, outcomes));
  }
  ReportSection parameters = parameters_section(facts);
  if (!parameters.parts.empty()) chapter.sections.push_back(std::move(parameters));
  chapter.sections.push_back(sessions_section(facts));
  ReportSection notes = notes_section(facts);
  if (!notes.parts.empty()) chapter.sections.push_back(std::move(notes));
  return chapter;
}

ReportChapter chapter_of(const ReportFacts& facts, const std::vector<ReportedOutcome>& outcomes,
                         const StudyMetadata& metadata) {
  ReportChapter chapter{chapter_heading(facts), mark_of(facts.group), facts.group, {}};
  chapter.sections.push_back(design_section(facts));
  chapter.sections.push_back(conditions_section(facts));
  chapter.sections.push_back(participants_section(facts));
  chapter.sections.push_back(exclusions_section(facts));
  if (is_held_back(facts)) {
    chapter.sections.push_back(
        {"Results",
         {ReportText{"A session of this protocol is running, and its experimenter is blind: create "
                     "the report again after the session to see the results.",
                     ReportText::Tone::notice}}});
  } else {
    for (const ReportedOutcome& each : outcomes) {
      chapter.sections.push_back(
          of_kind(results_section(*each.outcome, each.figures), each, outcomes));
    }
  }
  chapter.sections.push_back(exploration_section(facts));
  chapter.sections.push_back(presentation_section(facts));
  std::vector<const AnalysisOutcome*> shown{};
  for (const ReportedOutcome& each : outcomes) {
    if (!is_held_back(facts)) shown.push_back(each.outcome);
  }
  chapter.sections.push_back(paper_section(facts, shown, metadata));
  chapter.sections.push_back(making_section(facts));
  return chapter;
}

void number_parts(Report& report) {
  int tables = 0;
  int figures = 0;
  for (ReportChapter& chapter : report.chapters) {
    for (ReportSection& section : chapter.sections) {
      for (ReportPart& part : section.parts) {
        if (auto* table = std::get_if<ReportTable>(&part)) table->number = ++tables;
        if (auto* figure = std::get_if<ReportFigure>(&part)) {
          if (figure->figure.is_drawn()) figure->number = ++figures;
        }
      }
    }
  }
}

}  // namespace

Report study_report(const Study& study, const std::optional<std::string>& protocol,
                    const std::stop_token& stop, const std::function<void(double)>& progress) {
  Report report{};
  report.title = study.name();
  report.program = version_line();
  std::vector<ReportFacts> all{};
  std::vector<AnalysisOutcome> outcomes{};
  std::vector<WithdrawalRow> withdrawals{};
  StudyMetadata metadata{};
  study.read_at_one_moment([&] {
    withdrawals = study.withdrawals();
    metadata = study.metadata();
    all = report_facts(study, protocol, stop, [&progress](double fraction) {
      if (progress) progress(kFactsShare * fraction);
    });
    if (!stop.stop_requested()) outcomes = analyze_study(study, protocol, stop);
  });
  if (stop.stop_requested()) return report;
  for (AnalysisOutcome& outcome : outcomes) {
    if (!outcome.declares_sexes) outcome = without_sexes(std::move(outcome));
  }
  report.subtitle = dates_text(all, !withdrawals.empty());
  report.chapters.push_back(overview_chapter(all, withdrawals));
  // The main text comes first, reference material after it.
  std::vector<ReportChapter> appendices{};
  for (const ReportFacts& facts : all) {
    if (stop.stop_requested()) return report;
    const std::vector<ReportedOutcome> reported = outcomes_of(outcomes, facts);
    report.chapters.push_back(chapter_of(facts, reported, metadata));
    appendices.push_back(appendix_of(facts, reported));
  }
  std::move(appendices.begin(), appendices.end(), std::back_inserter(report.chapters));
  number_parts(report);
  if (progress) progress(1.0);
  return report;
}

}  // namespace asperity
