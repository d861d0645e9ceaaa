// The sections of a chapter of a report, one function each: counted facts in, words and tables out.

#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "app/findings/study/analysis_outcome.h"
#include "app/findings/study/task_words.h"
#include "app/report/text/report.h"
#include "app/report/text/report_facts.h"

namespace asperity {

/// Task, trials and order, as the protocol specifies them and the plans have them.
ReportSection design_section(const ReportFacts& facts);
/// The device, its force, the masking noise and what participants saw, as the sessions recorded them.
ReportSection conditions_section(const ReportFacts& facts);
/// How many, age, sex, handedness as stored.
ReportSection participants_section(const ReportFacts& facts);
/// What was left out and why, what was kept although something was noticed.
ReportSection exclusions_section(const ReportFacts& facts);
/// What became of the attempts that do not count: "three were not explored as instructed", one for each outcome.
std::vector<std::string> fates_of_attempts(const ReportFacts& facts);
/// Of those whose rows are in no number; of the study, since a deletion keeps no protocol either. One whose data were
/// kept first and deleted later has withdrawn twice.
ReportText withdrawals_text(std::span<const WithdrawalRow> withdrawals);
/// Whether the forces came in time and as they were meant.
ReportSection presentation_section(const ReportFacts& facts);
/// Whether hands did what they were asked to.
ReportSection exploration_section(const ReportFacts& facts);
/// Each question with its answer, method and figure; what was counted and tested; refusals.
ReportSection results_section(const AnalysisOutcome& outcome, std::span<const Figure> figures);
/// Program, device, files, seeds: what a replication needs.
ReportSection making_section(const ReportFacts& facts);
/// To look up: every session.
ReportSection sessions_section(const ReportFacts& facts);
/// To look up: notes, reasons of unblinding, of repeated trials and of decisions. Without parts where
/// there are none.
ReportSection notes_section(const ReportFacts& facts);
/// To look up: the other tables of the analysis with their figures.
ReportSection tables_section(const AnalysisOutcome& outcome, std::span<const Figure> figures);
/// To look up: tests and numbers that no table has, and where the rest is.
ReportSection numbers_section(const AnalysisOutcome& outcome);

/// Methods and results in paragraphs that a paper can print, with the publications that they cite. `outcome`: null where
/// the results are held back or there are none.
ReportSection paper_section(const ReportFacts& facts, const AnalysisOutcome* outcome,
                            const StudyMetadata& metadata);

/// What is stored of the participants, each empty where nothing is: "3 female and 3 male", "M = 22.3 years, SD = 2.0,
/// range 20 to 25", "6 right-handed".
struct SampleTexts {
  std::string sexes{};
  std::string ages{};
  std::string hands{};
};
SampleTexts sample_texts(const ReportFacts& facts);
/// "falcon Novint Falcon (in 2 of 3 sessions); mouse pointer of a window (in 1 of 3 sessions)"; empty where none is
/// recorded.
std::string devices_in(const ReportFacts& facts);
/// In which sessions participants moved no device or felt no force; empty where there are none.
std::string unfelt_force_text(const ReportFacts& facts);
/// What the rows support about masking noise, without what the protocol requests.
std::string recorded_noise_text(const ReportFacts& facts);
/// "speed (slow and fast)", "spacing (500 µm and 1 mm)": a factor by its name without the unit, with its levels.
std::string factor_text(const std::string& name, const Factor& factor);
/// "A session was planned with 42 experimental trials, and with 54 in total including anchors and practice."; empty where
/// no session has a plan.
std::string planned_trials_text(const ReportFacts& facts);
/// "in random order within each repetition, 3 repetitions, once for each level of speed"
std::string order_of_run(const Protocol::Block& block, const Protocol::Run& run);
/// "attempts outside these limits were flagged and included": what the protocol makes of them.
std::string after_failure(const Exploration& exploration);
/// "for 2 s to 15 s, with normal force from 0.3 N to 2.5 N (target 1 N)"
std::string instructed_exploration(const Exploration& exploration);

/// In how many sessions something is so.
struct SessionShare {
  std::size_t whole = 0;  ///< in all of their stretches
  std::size_t part = 0;   ///< in some of them
  std::size_t all = 0;

  bool is_any() const noexcept { return whole + part > 0; }
  /// "in 2 of 3 sessions", "in the only session", "in 1 of 4 sessions and in part of one more".
  std::string text() const;
  /// The same after a negation: "in any of the 3 sessions" where `text` is "in all 3 sessions".
  std::string text_after_not() const;
};
SessionShare share_of_sessions(const ReportFacts& facts,
                               const std::function<bool(const RecordedStretch&)>& is_so);
/// A virtual or recorded hand explored, not that of the participant who answered.
bool is_moved_by_program(const RecordedStretch& stretch);
/// The device has no motors: it is known to have given no force.
bool gives_no_force(const RecordedStretch& stretch);

/// "24 participants", "one virtual participant": the members of a group.
std::string participants_text(AnswerGroup group, std::size_t count);

/// With a capital letter. Not for what a study has named.
std::string capitalised(std::string text);
/// With a full stop, unless it has one.
std::string stopped(std::string text);

}  // namespace asperity
