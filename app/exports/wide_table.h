// One row per participant: what programs want that compare means of columns.

#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "app/exports/columns/export_column.h"
#include "app/exports/columns/study_vocabulary.h"

namespace asperity {

/// A table of one row per participant with, for each condition of each version of each protocol and
/// each question of a trial, one column for what can be averaged: the mean of answers that are numbers, else the
/// proportion of right answers where answers are right or wrong, else for each option the
/// proportion of answers that chose it; and how many answers those are of.
///
/// A condition is a combination of levels of the factors that have more than one level in the main
/// trials of the protocol. Counted are answers of the main phase that are valid and not excluded;
/// how many were flagged, and how many were left out, are columns.
///
/// Answers to the questions of a session are columns too; of several sessions with one protocol the
/// last one's.
///
/// Versions of a protocol are never counted together, nor are two sources that call themselves the
/// same version, unless they differ in nothing but texts: those of two languages. Descriptions name the version; names of columns do only where there is more than
/// one, and the beginning of the source's SHA-256 only where one version has two.
class WideTable final {
 public:
  WideTable(const StudyVocabulary& vocabulary, ExportAudience audience);

  /// `at` with participant.
  void begin_participant(const ExportPlace& at);
  /// `at` with a session of that participant.
  void begin_session(const ExportPlace& at);
  /// `at` with session, trial, attempt and one of its responses.
  void add_answer(const ExportPlace& at);
  /// `at` with session and an answer to one of its own questions; the last one stays.
  void add_session_answer(const ExportPlace& at);

  struct Made {
    std::vector<ExportColumn> columns{};  ///< without the functions that make cells
    std::vector<std::string> left_out{};
    std::vector<std::vector<Cell>> rows{};
  };
  Made make() const;

 private:
  using Level = std::pair<double, std::string>;  ///< numbers in their order, names in theirs
  using Condition = std::vector<std::pair<std::string, Level>>;  ///< by name of the factor
  struct Asked {
    std::string protocol{};
    std::string version{};
    std::string source_sha256{};  ///< of the first that differs in nothing but texts
    std::string question{};
    auto operator<=>(const Asked&) const = default;
  };
  class ProtocolNames;
  Asked asked_of(const ExportPlace& at) const;  ///< with a response
  struct Tally {
    std::int64_t answers = 0;
    std::int64_t numbers = 0;
    double sum = 0.0;
    std::int64_t judged = 0;
    std::int64_t right = 0;
    std::map<std::string, std::int64_t> chosen{};
  };
  struct Person {
    std::vector<Cell> about{};
    std::map<Asked, std::map<Condition, Tally>> tallies{};
    std::map<Asked, Cell> said{};  ///< answers to questions of the session
    std::int64_t answers = 0;
    std::int64_t flagged = 0;
    std::int64_t left_out = 0;
    std::int64_t doubted = 0;
    std::int64_t unfinished = 0;
  };

  ExportAudience audience_;
  std::vector<ExportColumn> about_{};
  std::vector<std::string> left_out_{};
  StudyVocabulary vocabulary_{};
  std::set<std::string> withheld_{};  ///< questions of sessions that the public does not get
  std::vector<Person> people_{};
};

}  // namespace asperity
