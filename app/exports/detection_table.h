// Makes detection.tsv of an export: hits and false alarms of tasks whose responses are words.

#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/exports/columns/export_column.h"
#include "app/exports/columns/study_vocabulary.h"
#include "app/exports/export_folder.h"

namespace asperity {

/// The block of discrimination to which the response of a trial belongs; null where it answers another question.
const StudyVocabulary::BlockOfDiscrimination* discrimination_of(const StudyVocabulary& vocabulary,
                                                                const ExportPlace& at);

/// The number of comparisons among the presented surfaces.
std::size_t comparisons_in(const AttemptRow& attempt);

/// For each participant, yes/no or same–different task, level of its parameter and combination of the levels of the other
/// factors that are not drawn for every trial: responses "yes" or "different" in trials with a signal at this level (hits),
/// and in all trials of the combination without a signal (false alarms). The rows are a table of the family `dprime`.
///
/// Responses count as in FitTable.
class DetectionTable final {
 public:
  explicit DetectionTable(const StudyVocabulary& vocabulary) : vocabulary_(vocabulary) {}

  static std::vector<ExportColumn> columns();

  /// `at` with a session, a trial, an attempt and one of its responses: those of other tasks are left out.
  void add(const ExportPlace& at);
  bool is_empty() const noexcept;
  void write(ExportFolder& folder, const std::string& name) const;

 private:
  struct Task {
    std::string participant{};
    std::string protocol{};
    std::string version{};
    std::string source_sha256{};
    std::string question{};
    std::string design{};  ///< as in the family `dprime`
    std::string factor{};
    std::string others{};  ///< "order = first, texture = stone"
    auto operator<=>(const Task&) const = default;
  };
  struct Count {
    std::int64_t yes = 0;
    std::int64_t trials = 0;
  };
  struct Counts {
    std::map<double, Count> signal{};  ///< by level
    Count noise{};
    double standard = 0.0;
  };

  const StudyVocabulary& vocabulary_;
  std::map<Task, Counts> tasks_{};
};

}  // namespace asperity
