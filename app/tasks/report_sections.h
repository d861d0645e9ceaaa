// The sections of a chapter of a report, one function each: counted facts in, words and tables out.

#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/analyses/analysis_outcome.h"
#include "app/tasks/report.h"
#include "app/tasks/report_facts.h"

namespace asperity {

/// What was asked, with what, in which order, as the protocol's file says it.
ReportSection design_section(const ReportFacts& facts);
/// How many, age, sex, handedness as stored.
ReportSection participants_section(const ReportFacts& facts);
/// What was left out and why, what was kept although something was noticed.
ReportSection exclusions_section(const ReportFacts& facts);
/// Whether the forces came in time and as they were meant.
ReportSection presentation_section(const ReportFacts& facts);
/// Whether hands did what they were asked to.
ReportSection exploration_section(const ReportFacts& facts);
/// Each question with its answer, method and figure; what was counted and tested; refusals.
ReportSection results_section(const AnalysisOutcome& outcome, std::span<const Figure> figures);
/// Program, device, files, seeds: what somebody needs to do it again.
ReportSection making_section(const ReportFacts& facts);
/// To look up: every session.
ReportSection sessions_section(const ReportFacts& facts);
/// To look up: the other tables of the analysis with their figures.
ReportSection tables_section(const AnalysisOutcome& outcome, std::span<const Figure> figures);
/// To look up: tests and numbers that no table has, and where the rest is.
ReportSection numbers_section(const AnalysisOutcome& outcome);

/// "24 persons", "one virtual participant": whoever a group consists of.
std::string persons_text(AnswerGroup group, std::size_t count);

/// "a", "a and b", "a, b and c".
std::string listed(const std::vector<std::string>& words);

/// With a capital letter. Not for what a study has named.
std::string capitalised(std::string text);
/// With a full stop, unless it has one.
std::string stopped(std::string text);

}  // namespace asperity
