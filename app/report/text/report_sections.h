// Writes the sections of a chapter of a report, one function each, from the counted facts.

#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/outcome/task_words.h"
#include "app/report/text/report.h"
#include "app/report/text/report_facts.h"

namespace asperity {

/// Task, trials and order, as specified by the protocol and as planned.
ReportSection design_section(const ReportFacts& facts);
/// The device, its force, the masking noise and what participants saw, as the sessions recorded
/// them.
ReportSection conditions_section(const ReportFacts& facts);
/// Number, age, sex and handedness as stored.
ReportSection participants_section(const ReportFacts& facts);
/// What was omitted and why, and what was kept despite a warning.
ReportSection exclusions_section(const ReportFacts& facts);
/// The attempts that do not count: "three were not explored as instructed", one text for each outcome.
std::vector<std::string> fates_of_attempts(const ReportFacts& facts);
/// The withdrawals of participants whose rows are excluded from all numbers; for the whole study,
/// since a deletion keeps no protocol either. A participant whose data were first kept and later
/// deleted is counted twice.
ReportText withdrawals_text(std::span<const WithdrawalRow> withdrawals);
/// Whether the forces were rendered on time and as intended.
ReportSection presentation_section(const ReportFacts& facts);
/// Whether participants complied with the instructed exploration.
ReportSection exploration_section(const ReportFacts& facts);
/// Each question with its answer, method and figure; counts and tests; numbers that could not be
/// computed.
ReportSection results_section(const AnalysisOutcome& outcome, std::span<const Figure> figures);
/// Program, device, files, seeds: the requirements of a replication.
ReportSection making_section(const ReportFacts& facts);
/// For reference: every session.
ReportSection sessions_section(const ReportFacts& facts);
/// For reference: notes, reasons of unblinding, of repeated trials and of decisions. Without parts
/// where there are none.
ReportSection notes_section(const ReportFacts& facts);
/// For reference: the other tables of the analysis with their figures.
ReportSection tables_section(const AnalysisOutcome& outcome, std::span<const Figure> figures);
/// For reference: tests and numbers that are in no table, and where to find the rest.
ReportSection numbers_section(const AnalysisOutcome& outcome);

/// Methods and results in paragraphs for a paper, with the publications that they cite. `outcomes`:
/// one for each kind of responses; empty where the results are withheld or there are none.
ReportSection paper_section(const ReportFacts& facts,
                            std::span<const AnalysisOutcome* const> outcomes,
                            const StudyMetadata& metadata);

/// The stored sample, each text empty where nothing is stored: "3 female and 3 male", "M = 22.3
/// years, SD = 2.0, range 20 to 25", "6 right-handed".
struct SampleTexts {
  std::string sexes{};
  std::string ages{};
  std::string hands{};
};
SampleTexts sample_texts(const ReportFacts& facts);
/// "Participants were assigned to two groups of the factor training (haptic, n = 10; visual, n = 9), by the
/// experimenter."; empty without groups.
std::string groups_text(const ReportFacts& facts);
/// "falcon Novint Falcon (in 2 of 3 sessions); mouse pointer of a window (in 1 of 3 sessions)"; empty where none is
/// recorded.
std::string devices_in(const ReportFacts& facts);
/// The sessions in which participants moved no device or felt no force; empty where there are none.
std::string unfelt_force_text(const ReportFacts& facts);
/// The external programs that stated levels, each with its number of sessions, and their failures; empty without any.
std::string external_programs_text(const ReportFacts& facts);
/// The masking noise as recorded, without the protocol's requests.
std::string recorded_noise_text(const ReportFacts& facts);
/// "speed (slow and fast)", "spacing (500 µm and 1 mm)": a factor by its name without the unit, with its levels.
std::string factor_text(const std::string& name, const Factor& factor);
/// "attempts outside these limits were flagged and included": the consequence that the protocol
/// specifies.
std::string after_failure(const Exploration& exploration);
/// "for 2 s to 15 s, with normal force from 0.3 N to 2.5 N (target 1 N)"
std::string instructed_exploration(const Exploration& exploration);

/// The number of sessions with a property.
struct SessionShare {
  std::size_t whole = 0;  ///< in all of their stretches
  std::size_t part = 0;   ///< in some of their stretches
  std::size_t all = 0;

  bool is_any() const noexcept { return whole + part > 0; }
  /// "in 2 of 3 sessions", "in the only session", "in 1 of 4 sessions and in part of one more".
  std::string text() const;
  /// The same after a negation: "in any of the 3 sessions" where `text` is "in all 3 sessions".
  std::string text_after_not() const;
};
SessionShare share_of_sessions(const ReportFacts& facts,
                               const std::function<bool(const RecordedStretch&)>& is_so);
/// Whether a virtual or recorded hand explored, and not that of the participant who responded.
bool is_moved_by_program(const RecordedStretch& stretch);
/// Whether the device has no motors, and therefore gave no force.
bool gives_no_force(const RecordedStretch& stretch);

/// "24 participants", "one virtual participant": the members of a group.
std::string participants_text(AnswerGroup group, std::size_t count);

/// With a capital letter. Not for names from a study.
std::string capitalised(std::string text);
/// With a full stop at the end.
std::string stopped(std::string text);

}  // namespace asperity
