// Converts the responses of a study to columns of a tidy table, with one row per response.

#pragma once

#include <cstddef>
#include <string>
#include <unordered_map>
#include <utility>

#include "app/findings/gathering/gathered_answers.h"
#include "app/findings/tidy/tidy_families.h"
#include "results_schema/tables/tidy_table.h"

namespace asperity {

/// The participants by label, as names of a column without rows yet.
LabelColumn labels_of_people(const GatheredAnswers& gathered);
/// The participants, by label.
LabelColumn column_of_people(const GatheredAnswers& gathered);
/// Response times in seconds; missing where there is none.
NumberColumn column_of_times(const GatheredAnswers& gathered);

/// A column of names, filled row by row.
class LabelRows final {
 public:
  /// An empty name is a missing cell.
  void add(const std::string& name);
  LabelColumn take() && { return std::move(column_); }

 private:
  LabelColumn column_{};
  std::unordered_map<std::string, std::size_t> code_of_{};
};

/// A table with a row per score that a participant gives an item, for the families `rating`, `icc` and `ordinal`.
class ScoreRows final {
 public:
  explicit ScoreRows(const GatheredAnswers& gathered) : people_(labels_of_people(gathered)) {}
  /// `person`: index of the gathered people.
  void add(std::size_t person, const std::string& item, double score);
  /// `rater`, `rated`, `score`: the names of the columns of participants, items and scores.
  TidyInput take(const char* rater, const char* rated, const std::string& about,
                 const char* score = "score") &&;

 private:
  LabelColumn people_{};
  LabelRows items_{};
  NumberColumn scores_{};
};

}  // namespace asperity
