// Takes α as ICC(3,k) of the complete rows, with its F interval; the other interval resamples whole clusters.

#include "analysis/scales/cronbach_alpha.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>

#include <Eigen/Core>

#include "analysis/numbers/number_text.h"
#include "analysis/numbers/summary.h"
#include "analysis/numbers/tail_probabilities.h"
#include "analysis/scales/intraclass.h"

namespace asperity {

CronbachAlpha cronbach_alpha(std::span<const std::vector<std::optional<double>>> scores,
                             double confidence) {
  static_cast<void>(normal_limit(confidence));  // refuses a confidence that is not a probability
  if (scores.empty())
    throw std::invalid_argument("scores is empty; at least one respondent is needed");
  CronbachAlpha answer{.items = scores.front().size()};
  if (answer.items < 2) {
    throw std::invalid_argument("scores has " + counted(answer.items, "item", "items") +
                                "; at least 2 are needed");
  }
  std::vector<const std::vector<std::optional<double>>*> complete{};
  for (const auto& row : scores) {
    if (row.size() != answer.items) {
      throw std::invalid_argument(
          "scores: a respondent has " + counted(row.size(), "item", "items") +
          "; the number must be that of the first respondent, " + std::to_string(answer.items));
    }
    for (const std::optional<double>& score : row) {
      if (score && !std::isfinite(*score)) {
        throw std::invalid_argument("scores: a score is " + number_text(*score) +
                                    "; all must be finite");
      }
    }
    if (std::all_of(row.begin(), row.end(), [](const auto& score) { return score.has_value(); })) {
      complete.push_back(&row);
    }
  }
  answer.respondents = complete.size();
  answer.left_out = scores.size() - complete.size();
  if (complete.size() < 2) return answer;
  Eigen::MatrixXd ratings(static_cast<Eigen::Index>(answer.respondents),
                          static_cast<Eigen::Index>(answer.items));
  for (Eigen::Index row = 0; row < ratings.rows(); ++row) {
    for (Eigen::Index item = 0; item < ratings.cols(); ++item) {
      ratings(row, item) =
          *(*complete[static_cast<std::size_t>(row)])[static_cast<std::size_t>(item)];
    }
  }
  const std::optional<Reliability> reliability = reliability_of(ratings, confidence);
  if (!reliability) return answer;
  const IntraclassCorrelation& consistency_of_mean = reliability->correlations[5];
  if (consistency_of_mean.F == 0.0) return answer;  // all sums are equal
  answer.value = consistency_of_mean.value;
  answer.interval = consistency_of_mean.interval;
  return answer;
}

std::optional<ConfidenceInterval> cronbach_alpha_interval(
    std::span<const std::vector<std::optional<double>>> scores,
    std::span<const std::size_t> cluster, const ClusterResampling& resampling,
    const Random& random) {
  if (cluster.size() != scores.size()) {
    throw std::invalid_argument("cluster has " + counted(cluster.size(), "row", "rows") +
                                "; scores has " + std::to_string(scores.size()));
  }
  static_cast<void>(cronbach_alpha(scores, resampling.confidence));  // refuses impossible scores
  std::vector<std::vector<std::size_t>> rows_of{};
  for (std::size_t row = 0; row < cluster.size(); ++row) {
    if (cluster[row] >= rows_of.size()) rows_of.resize(cluster[row] + 1);
    rows_of[cluster[row]].push_back(row);
  }
  std::erase_if(rows_of, [](const auto& rows) { return rows.empty(); });
  if (rows_of.size() < 2) return std::nullopt;
  std::vector<double> values{};
  std::vector<std::vector<std::optional<double>>> drawn{};
  for (std::size_t draw = 0; draw < resampling.draws; ++draw) {
    Random of_draw = random.split(static_cast<std::uint64_t>(draw));
    drawn.clear();
    for (std::size_t i = 0; i < rows_of.size(); ++i) {
      for (const std::size_t row : rows_of[of_draw.below(rows_of.size())]) {
        drawn.push_back(scores[row]);
      }
    }
    const std::optional<double> value = cronbach_alpha(drawn, resampling.confidence).value;
    if (value) values.push_back(*value);
  }
  constexpr double kMostUndefined = 0.1;
  if (static_cast<double>(values.size()) <
      (1.0 - kMostUndefined) * static_cast<double>(resampling.draws)) {
    return std::nullopt;
  }
  std::sort(values.begin(), values.end());
  const double tail = 0.5 - resampling.confidence / 2.0;
  return ConfidenceInterval{quantile(values, tail), quantile(values, 1.0 - tail)};
}

}  // namespace asperity
