// Makes the table with one row per participant, for programs that compare means of columns.

#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "app/exports/columns/export_column.h"
#include "app/exports/columns/study_vocabulary.h"
#include "app/exports/wide_answers.h"
#include "app/exports/wide_columns.h"

namespace asperity {

/// A table of one row per participant with, for each condition of each version of each protocol and
/// each question of a trial, one column for the average: the mean of answers that are numbers,
/// otherwise the proportion correct where responses are correct or incorrect, otherwise for each
/// option the proportion of responses that chose it; and the number of responses averaged. A discrimination has thresholds
/// in place of averages (ThresholdColumns).
///
/// A condition is a combination of levels of the factors that have more than one level in the main
/// trials of the protocol. Responses of the main phase that are valid and not excluded are
/// averaged; the numbers of flagged and of omitted responses are columns.
///
/// Answers to the questions of a session are columns too; of several sessions with one protocol,
/// those of the last one.
///
/// Versions of a protocol are never combined, nor are two sources with the same version, unless
/// they differ only in texts: those of two languages. Descriptions name the version; names of
/// columns do so only where there is more than one, and contain the beginning of the source's
/// SHA-256 only where one version has two sources.
class WideTable final {
 public:
  WideTable(const StudyVocabulary& vocabulary, ExportAudience audience);

  /// `at` with participant.
  void begin_participant(const ExportPlace& at);
  /// `at` with a session of that participant.
  void begin_session(const ExportPlace& at);
  /// `at` with session, trial, attempt and one of its responses.
  void add_answer(const ExportPlace& at);
  /// `at` with a session and an answer to one of its questions; the last one is kept.
  void add_session_answer(const ExportPlace& at);

  struct Made {
    WideColumns table{};
    std::vector<std::string> left_out{};
  };
  Made make() const;

 private:
  using Asked = WideAnswers::Asked;
  using Condition = WideAnswers::Condition;
  using Level = WideAnswers::Level;
  using Person = WideAnswers::Person;
  using Tally = WideAnswers::Tally;
  Asked asked_of(const ExportPlace& at) const;     ///< with a response
  Asked protocol_of(const ExportPlace& at) const;  ///< without a question
  /// In a yes/no or same–different task, in which responses to trials with and without a signal must not be averaged
  /// together: adds whether there was a signal, and removes the level of a trial without one.
  void mark_signal(const ExportPlace& at, Condition& condition) const;
  /// False where the response does not belong to a discrimination.
  bool add_discrimination(const ExportPlace& at, const Condition& condition);
  /// Whether the level of the trial was chosen from earlier responses: a mean over such trials depends on the levels.
  bool is_level_of_procedure(const ExportPlace& at) const;

  /// The session, trial and attempt of a response, and its question.
  using Counted = std::tuple<std::int64_t, int, int, std::string>;

  ExportAudience audience_;
  std::vector<ExportColumn> about_{};
  std::vector<std::string> left_out_{};
  StudyVocabulary vocabulary_{};
  std::set<std::string> withheld_{};  ///< questions of sessions that are not published
  WideAnswers gathered_{};
  std::optional<Counted> last_counted_{};
};

}  // namespace asperity
