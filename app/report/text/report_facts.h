// Stores the counts and facts from which a chapter of a report is written.

#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <stop_token>
#include <string>
#include <tuple>
#include <vector>

#include "app/findings/gathering/gathered_answers.h"
#include "app/records/presented_matches.h"
#include "app/records/session_conditions.h"
#include "app/tasks/check_protocol.h"
#include "results_schema/study.h"

namespace asperity {

/// An event in the experimenter's words.
struct ReportedNote {
  std::string kind{};
  std::string text{};
  double time_s = 0.0;         ///< since the session began
  std::optional<int> trial{};  ///< the current trial, or the one that it refers to
};

struct ReportedSession {
  SessionRow row{};
  int planned_trials = 0;
  bool planned_is_estimated = false;  ///< as in SessionOverview
  int done_trials = 0;                ///< as in SessionOverview
  int main_trials = 0;                ///< of the planned ones
  /// Trials with an attempt that is no refresher: all, those of the main phase, and those of each run of a block.
  int presented_trials = 0;
  int presented_main_trials = 0;
  std::map<std::pair<std::string, int>, int> presented_in_run{};  ///< by block and its ordinal
  std::size_t counted_attempts = 0;                               ///< that analyses include
  std::size_t resumed = 0;                                        ///< the number of times
  bool is_running = false;
  /// The participant neither saw nor heard the guidance that the protocol requests.
  bool is_unguided = false;
  /// The blocks that ended without meeting their criterion.
  std::set<std::string> unmet_criteria{};
  std::vector<RecordedStretch> stretches{};
  std::vector<DecisionRow> decisions{};
  std::vector<EventRow> late_resumes{};  ///< see kResumedLate
  /// `external_program`, of each start that was followed by a statement (`external_level`).
  std::vector<EventRow> external_programs{};
  std::size_t external_failures = 0;
  std::vector<ReportedNote> notes{};  ///< in chronological order
};

/// A count of ticks or records, over attempts or presentations.
struct ReportedCount {
  std::int64_t total = 0;
  std::int64_t worst = 0;    ///< the maximum of a single one
  std::size_t affected = 0;  ///< the number of those with a count above 0
  std::size_t of = 0;

  void add(std::int64_t count);
};

struct ReportedServo {
  std::size_t attempts = 0;
  std::int64_t ticks = 0;
  std::vector<double> lateness_p50_s{};  ///< of each attempt; the next ones accordingly
  std::vector<double> lateness_p99_s{};
  std::vector<double> lateness_maximum_s{};
  std::vector<double> period_p99_s{};
  std::vector<double> execution_p99_s{};
  ReportedCount missed_deadlines{};
  ReportedCount missed_in_contact{};
  ReportedCount gaps_in_contact{};
  ReportedCount held_readings{};
  ReportedCount lost_records{};
  ReportedCount saturated{};
  ReportedCount slew_limited{};
  ReportedCount not_finite{};
  std::map<std::string, std::size_t> faults{};  ///< other than none
};

/// One quantity with one band, over all presentations that were compared with it.
struct ReportedBand {
  std::vector<double> means{};      ///< of strokes: where there was at least one
  std::vector<double> fractions{};  ///< inside the band: of the contact time, or of the strokes
  std::size_t passed = 0;
  std::size_t judged = 0;  ///< where the protocol sets a requirement for it
};

/// Attempts with the same outcome, by their reasons.
using ReasonCounts = std::map<std::string, std::size_t>;

/// In `ReportFacts::other_kinds`.
inline constexpr const char* kCatchTrialsKind = "catch trials";

struct ReportFacts {
  ProtocolRow protocol{};  ///< the first of its files
  ProtocolCheck file{};    ///< the parsed protocol, or why it cannot be read
  ModelRegistry
      declared_models{};  ///< the built-in ones, and the declared ones of the study's plug-ins
  std::set<std::string> sources{};  ///< SHA-256 of all files of this name and version
  bool are_translations = true;     ///< those files are one protocol in several languages
  /// The participants with a session in each language, by their labels.
  std::map<std::string, std::set<std::string>> languages{};
  AnswerGroup group = AnswerGroup::people;
  std::vector<ParticipantRow> participants{};  ///< by label
  std::vector<ReportedSession> sessions{};     ///< by participant, session
  std::vector<WithdrawalRow> withdrawals{};    ///< in the whole study, of this group

  std::size_t attempts = 0;                      ///< of the main phase
  std::size_t counted = 0;                       ///< of those: answered, valid and not excluded
  std::set<std::string> counted_participants{};  ///< with at least one counted attempt
  std::size_t other_attempts =
      0;                       ///< of familiarisation and practice, at anchors and at catch trials
  std::size_t refreshers = 0;  ///< of those: practice repeated at a resume
  std::set<std::int64_t> refreshed_sessions{};  ///< with such attempts
  std::set<std::string> other_kinds{};          ///< the purposes of those: "practice", "anchors"
  std::set<std::string> other_planned{};        ///< the same in the plans
  std::map<std::string, ReasonCounts> not_counted{};  ///< by outcome, then reason
  ReasonCounts flagged{};                             ///< of the attempts that count

  ReportedServo servo{};  ///< of every attempt
  /// (model, kind, texture or else stimulus) → ticks
  std::map<std::tuple<std::string, std::string, std::string>, ReportedCount> limits{};
  /// (quantity, minimum, maximum) →
  std::map<std::tuple<std::string, std::optional<double>, std::optional<double>>, ReportedBand>
      bands{};
  std::set<std::string> models{};  ///< presented, with their versions: "height_map 1"
  /// Of those that are plug-ins, by model and version: the SHA-256 of each build.
  std::map<std::string, std::set<std::string>> plugin_builds{};
  std::map<std::string, std::string> plugin_files{};  ///< SHA-256 → the name of its file
  std::set<std::string> height_fields{};              ///< textures that were rendered from one
  std::set<std::string> body_textures{};              ///< textures of the presented bodies
  std::set<std::string> points_on_bodies{};           ///< stimuli of point models on bodies
  /// Of surfaces at amplitudes of equal roughness in counted attempts: the number of matches of all sessions, by status.
  std::map<MatchStatus, std::size_t> roughness_matches{};
  bool has_equal_force = false;          ///< the texture force of a presentation was matched
  std::set<double> stiffness_N_per_m{};  ///< of the surfaces presented, where it is stored
  std::set<double> friction{};           ///< the same: the coefficient
  /// Of the surfaces in counted attempts: model → parameter → the values as rendered, without those of friction laws that
  /// were not used
  std::map<std::string, std::map<std::string, std::set<ParameterValue>>> parameters{};
  std::set<std::size_t> surfaces{};  ///< the numbers of surfaces presented in answered attempts
  std::set<std::string> answer_sources{};  ///< "keyboard"

  bool is_running() const;
};

/// By protocol, version and group, as in `gather_answers`. Errors: ResultsError.
std::vector<ReportFacts> report_facts(const Study& study,
                                      const std::optional<std::string>& protocol,
                                      const std::stop_token& stop,
                                      const std::function<void(double)>& progress);

}  // namespace asperity
