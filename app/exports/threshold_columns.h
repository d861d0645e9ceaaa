// Makes the columns of the wide table for the thresholds of a discrimination.

#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "app/exports/columns/export_column.h"
#include "app/exports/columns/study_vocabulary.h"
#include "app/findings/methods/discrimination/thresholds/discrimination_thresholds.h"

namespace asperity {

/// The choices of the participants in one discrimination, by condition, and their thresholds as columns: for each condition
/// the point of subjective equality (judgement of comparison), the just-noticeable difference, the Weber fraction (unless
/// the standard is 0) and the number of responses; the number of unfinished tracks, where any participant has one. Proportions of responses over the levels are not columns: they depend on
/// how the levels were chosen.
class ThresholdColumns final {
 public:
  /// By name of the factor: the level as a number, 0 for a name, and as text.
  using Condition = std::vector<std::pair<std::string, std::pair<double, std::string>>>;

  /// `person`: index of the row. `block`: its name, a condition where the task has several. `condition`: without the factor
  /// of the level. `of`: must outlive this object.
  void add(std::size_t person, const StudyVocabulary::BlockOfDiscrimination& of,
           const std::string& block, const Condition& condition, const DiscriminationTrial& trial);

  struct Column {
    ExportColumn column{};
    std::map<std::size_t, Cell> cells{};  ///< by person; missing where there is none
  };
  /// `name`: the beginning of the names; `of`: the end of the descriptions.
  std::vector<Column> make(const std::string& name, const std::string& of) const;

 private:
  struct OfTask {
    DiscriminationTask task{};
    struct Choices {
      HitsByValue of_comparison{};
      bool by_procedure = false;
      /// The trials of tracks in sessions that are not completed, by session, block ordinal and track.
      std::map<std::tuple<int, int, int>, std::vector<DiscriminationTrial>>
          in_unfinished_sessions{};
      const StudyVocabulary::BlockOfDiscrimination* block = nullptr;

      std::int64_t unfinished_tracks() const;
    };
    std::map<Condition, std::map<std::size_t, Choices>> choices{};
  };
  std::vector<Column> make_task(const OfTask& of_task, const std::string& name,
                                const std::string& of) const;

  std::vector<OfTask> tasks_{};
};

}  // namespace asperity
