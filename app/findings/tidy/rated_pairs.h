// Reads the dissimilarities that raters gave to pairs of items, for the family `similarity`.

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "analysis/dissimilarity/rated_dissimilarities.h"
#include "results_schema/tables/tidy_table.h"

namespace asperity {

/// One judgement, in the order of the rows.
struct PairJudgement {
  std::size_t rater = 0;
  std::size_t first = 0;  ///< places in `items`, in the order of presentation
  std::size_t second = 0;
  double dissimilarity = 0.0;
};

/// The judgements of all raters, and what follows from them alone.
struct JudgedPairs {
  std::vector<std::string> items{};
  std::vector<std::string> raters{};
  std::vector<PairJudgement> judgements{};

  /// Each rater's means of the pairs of different items, whatever their order; the weights are numbers of judgements.
  std::vector<RatedPairs> by_rater() const;
  /// The first and the last judgement of every pair of different items that a rater judged repeatedly.
  struct Repeated {
    std::vector<double> first{};
    std::vector<double> last{};
  };
  Repeated repeated_by(std::size_t rater) const;
  /// A rater's means of the judgements in the two orders of a pair, where there are both.
  Repeated in_both_orders_by(std::size_t rater) const;
  /// The mean of a rater's judgements of pairs of an item with itself, or of pairs of different items.
  std::optional<double> mean_of_identical_by(std::size_t rater) const;
  std::optional<double> mean_of_different_by(std::size_t rater) const;
};

/// From the columns subject, first, second, dissimilarity. `items`: in their order; empty: as they first occur.
JudgedPairs judged_pairs_in(const TidyTable& table, std::vector<std::string> items);

/// Nothing where there are fewer than three pairs of values, or one of the two is constant.
std::optional<double> pearson_correlation(const std::vector<double>& a,
                                          const std::vector<double>& b);

}  // namespace asperity
