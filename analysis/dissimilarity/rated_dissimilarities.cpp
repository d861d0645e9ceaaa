// Means, permutations, folds and resamples of raters.

#include "analysis/dissimilarity/rated_dissimilarities.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include <Eigen/Eigenvalues>

#include "analysis/dissimilarity/procrustes.h"
#include "analysis/numbers/isotonic_regression.h"
#include "analysis/numbers/number_text.h"
#include "analysis/numbers/summary.h"

namespace asperity {
namespace {

bool is_rated(const RatedPairs& rater, Eigen::Index i, Eigen::Index j) {
  return rater.weights.size() == 0 || rater.weights(i, j) > 0.0;
}

struct PlaceOfPair {
  Eigen::Index i = 0;
  Eigen::Index j = 0;
};

std::vector<PlaceOfPair> pairs_rated_by(const RatedPairs& rater) {
  std::vector<PlaceOfPair> pairs{};
  for (Eigen::Index i = 0; i < rater.values.rows(); ++i) {
    for (Eigen::Index j = i + 1; j < rater.values.cols(); ++j) {
      if (is_rated(rater, i, j)) pairs.push_back({.i = i, .j = j});
    }
  }
  return pairs;
}

RatedPairs permuted(const RatedPairs& rater, Random random) {
  const std::vector<PlaceOfPair> pairs = pairs_rated_by(rater);
  std::vector<double> judgements{};
  for (const PlaceOfPair& pair : pairs) judgements.push_back(rater.values(pair.i, pair.j));
  random.shuffle(std::span(judgements));
  RatedPairs made = rater;
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    made.values(pairs[p].i, pairs[p].j) = judgements[p];
    made.values(pairs[p].j, pairs[p].i) = judgements[p];
  }
  return made;
}

std::vector<RatedPairs> all_but(std::span<const RatedPairs> raters, std::size_t left_out) {
  std::vector<RatedPairs> others{};
  for (std::size_t s = 0; s < raters.size(); ++s) {
    if (s != left_out) others.push_back(raters[s]);
  }
  return others;
}

/// The judgement that others' judgements predict for every pair, from the distances of their configuration.
Dissimilarities predicted_by(const WeightedDissimilarities& others, const Eigen::MatrixXd& points) {
  struct Pair {
    PlaceOfPair at{};
    double distance = 0.0;
  };
  const Dissimilarities distances = distances_between(points);
  std::vector<Pair> pairs{};
  for (const PlaceOfPair& at : pairs_rated_by(others))
    pairs.push_back({.at = at, .distance = distances(at.i, at.j)});
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Pair& a, const Pair& b) { return a.distance < b.distance; });
  std::vector<double> judgements{};
  std::vector<double> weights{};
  for (const Pair& pair : pairs) {
    judgements.push_back(others.values(pair.at.i, pair.at.j));
    weights.push_back(others.weights(pair.at.i, pair.at.j));
  }
  const std::vector<double> fitted = isotonic_regression(judgements, weights);
  // Pairs that only the rater judged lie between their neighbours in distance.
  Dissimilarities predicted = Dissimilarities::Zero(distances.rows(), distances.cols());
  for (Eigen::Index i = 0; i < distances.rows(); ++i) {
    for (Eigen::Index j = i + 1; j < distances.cols(); ++j) {
      const auto above =
          std::upper_bound(pairs.begin(), pairs.end(), distances(i, j),
                           [](double d, const Pair& pair) { return d < pair.distance; });
      const std::size_t place =
          above == pairs.begin() ? 0 : static_cast<std::size_t>(above - pairs.begin()) - 1;
      predicted(i, j) = fitted[place];
      predicted(j, i) = fitted[place];
    }
  }
  return predicted;
}

double mean_square_of(const RatedPairs& rater, const Dissimilarities& predicted) {
  double square = 0.0;
  const std::vector<PlaceOfPair> pairs = pairs_rated_by(rater);
  for (const PlaceOfPair& at : pairs) {
    const double difference = rater.values(at.i, at.j) - predicted(at.i, at.j);
    square += difference * difference;
  }
  return square / static_cast<double>(pairs.size());
}

double standard_error_of(const std::vector<double>& sample) {
  const Summary summary = *summary_of(sample);
  return summary.sd / std::sqrt(static_cast<double>(sample.size()));
}

}  // namespace

RatedPairs means_of_sums(RatedPairs sums) {
  const Eigen::Index m = sums.values.rows();
  for (Eigen::Index i = 0; i < m; ++i) {
    for (Eigen::Index j = i + 1; j < m; ++j) {
      if (sums.weights(i, j) > 0.0) sums.values(i, j) /= sums.weights(i, j);
      sums.values(j, i) = sums.values(i, j);
      sums.weights(j, i) = sums.weights(i, j);
    }
  }
  return sums;
}

WeightedDissimilarities mean_of_raters(std::span<const RatedPairs> raters) {
  if (raters.empty()) throw std::invalid_argument("raters is empty; at least one is needed");
  const Eigen::Index m = raters.front().values.rows();
  RatedPairs sums{.values = Dissimilarities::Zero(m, m), .weights = Eigen::MatrixXd::Zero(m, m)};
  for (const RatedPairs& rater : raters) {
    if (rater.values.rows() != m)
      throw std::invalid_argument("raters: all must have judged the same items");
    for (const PlaceOfPair& at : pairs_rated_by(rater)) {
      sums.values(at.i, at.j) += rater.values(at.i, at.j);
      sums.weights(at.i, at.j) += 1.0;
    }
  }
  return means_of_sums(std::move(sums));
}

std::vector<std::optional<double>> agreement_with_others(std::span<const RatedPairs> raters) {
  std::vector<std::optional<double>> agreement(raters.size());
  if (raters.size() < 2) return agreement;
  for (std::size_t s = 0; s < raters.size(); ++s) {
    const WeightedDissimilarities others = mean_of_raters(all_but(raters, s));
    std::vector<double> own{};
    std::vector<double> theirs{};
    for (const PlaceOfPair& at : pairs_rated_by(raters[s])) {
      if (!is_rated(others, at.i, at.j)) continue;
      own.push_back(raters[s].values(at.i, at.j));
      theirs.push_back(others.values(at.i, at.j));
    }
    const auto n = static_cast<Eigen::Index>(own.size());
    if (n < 3) continue;
    const Eigen::Map<const Eigen::ArrayXd> x(own.data(), n);
    const Eigen::Map<const Eigen::ArrayXd> y(theirs.data(), n);
    const Eigen::ArrayXd dx = x - x.mean();
    const Eigen::ArrayXd dy = y - y.mean();
    const double size = std::sqrt(dx.square().sum() * dy.square().sum());
    if (size > 0.0) agreement[s] = (dx * dy).sum() / size;
  }
  return agreement;
}

StressByChance stress_by_chance(std::span<const RatedPairs> raters, const ChanceQuestion& question,
                                const Random& random) {
  const ScalingQuestion fit{.dimensions = question.dimensions,
                            .level = question.level,
                            .random_starts = question.random_starts};
  StressByChance answer{.observed = scaled(mean_of_raters(raters), fit, random).stress_1,
                        .drawn = question.permutations};
  const double tied = std::max(answer.observed, StressByChance::kPerfectStress);
  std::size_t as_small = 1;  // the observed one
  std::vector<double> stresses{};
  for (std::size_t draw = 0; draw < question.permutations; ++draw) {
    const Random of_draw = random.split("permutation").split(static_cast<std::uint64_t>(draw));
    std::vector<RatedPairs> shuffled{};
    for (std::size_t s = 0; s < raters.size(); ++s)
      shuffled.push_back(permuted(raters[s], of_draw.split(static_cast<std::uint64_t>(s))));
    stresses.push_back(scaled(mean_of_raters(shuffled), fit, random).stress_1);
    if (stresses.back() <= tied) ++as_small;
    if (stresses.back() <= StressByChance::kPerfectStress) ++answer.perfect;
  }
  if (!stresses.empty()) {
    answer.mean = summary_of(stresses)->mean;
    std::sort(stresses.begin(), stresses.end());
    answer.p05 = quantile(stresses, 0.05);
  }
  answer.p = static_cast<double>(as_small) / static_cast<double>(question.permutations + 1);
  return answer;
}

std::size_t different_disparities(const WeightedDissimilarities& given, const Configuration& map) {
  constexpr double kSame = 0.01;
  std::vector<double> disparities{};
  for (const ShepardPoint& pair : shepard_diagram(given, map.points, ScalingLevel::ordinal)) {
    disparities.push_back(pair.disparity);
  }
  if (disparities.empty()) return 0;
  std::sort(disparities.begin(), disparities.end());
  std::size_t different = 1;
  for (std::size_t i = 1; i < disparities.size(); ++i) {
    if (disparities[i] - disparities[i - 1] > kSame * disparities.back()) ++different;
  }
  return different;
}

std::vector<Eigen::Index> collapsed_items(const WeightedDissimilarities& given,
                                          const Configuration& map) {
  constexpr double kSame = 0.01;
  constexpr std::size_t kFewest = 3;
  const std::vector<ShepardPoint> pairs = shepard_diagram(given, map.points, ScalingLevel::ordinal);
  double farthest = 0.0;
  double greatest = 0.0;
  for (const ShepardPoint& pair : pairs) {
    farthest = std::max(farthest, pair.distance);
    greatest = std::max(greatest, pair.dissimilarity);
  }
  std::vector<std::vector<Eigen::Index>> near(static_cast<std::size_t>(map.points.rows()));
  for (std::size_t item = 0; item < near.size(); ++item)
    near[item].push_back(static_cast<Eigen::Index>(item));
  for (const ShepardPoint& pair : pairs) {
    if (pair.distance > kSame * farthest || pair.dissimilarity <= kSame * greatest) continue;
    near[static_cast<std::size_t>(pair.first)].push_back(pair.second);
    near[static_cast<std::size_t>(pair.second)].push_back(pair.first);
  }
  std::vector<Eigen::Index> most{};
  for (std::vector<Eigen::Index>& items : near) {
    if (items.size() >= kFewest && items.size() > most.size()) most = std::move(items);
  }
  std::sort(most.begin(), most.end());
  return most;
}

std::optional<DimensionChoice> dimensions_by_cross_validation(std::span<const RatedPairs> raters,
                                                              std::span<const Configuration> maps,
                                                              ScalingLevel level) {
  constexpr std::size_t kFewestRaters = 3;
  if (raters.size() < kFewestRaters || maps.empty()) return std::nullopt;
  std::vector<std::vector<double>> squares(maps.size());  // by R and rater
  for (std::size_t s = 0; s < raters.size(); ++s) {
    const WeightedDissimilarities others = mean_of_raters(all_but(raters, s));
    if (!connects_all_items(others.weights)) return std::nullopt;
    if (pairs_rated_by(raters[s]).empty()) continue;
    for (std::size_t r = 0; r < maps.size(); ++r) {
      const Configuration fit = scaled_from(maps[r].points, others, level);
      squares[r].push_back(mean_square_of(raters[s], predicted_by(others, fit.points)));
    }
  }
  DimensionChoice choice{};
  std::size_t best = 0;
  for (std::size_t r = 0; r < maps.size(); ++r) {
    choice.errors.push_back(
        {.dimensions = maps[r].points.cols(), .error = std::sqrt(summary_of(squares[r])->mean)});
    if (choice.errors[r].error < choice.errors[best].error) best = r;
  }
  std::optional<Eigen::Index> chosen{};
  for (std::size_t r = 0; r < maps.size(); ++r) {
    std::vector<double> above{};
    for (std::size_t s = 0; s < squares[r].size(); ++s)
      above.push_back(squares[r][s] - squares[best][s]);
    choice.errors[r].above_best = summary_of(above)->mean;
    choice.errors[r].above_best_se = standard_error_of(above);
    if (!chosen && choice.errors[r].above_best <= choice.errors[r].above_best_se)
      chosen = choice.errors[r].dimensions;
  }
  choice.chosen = chosen.value_or(choice.errors[best].dimensions);
  return choice;
}

std::optional<std::vector<PositionRegion>> bootstrap_regions(std::span<const RatedPairs> raters,
                                                             const Configuration& map,
                                                             ScalingLevel level,
                                                             const BootstrapQuestion& question,
                                                             const Random& random) {
  constexpr std::size_t kFewestRaters = 3;
  if (raters.size() < kFewestRaters || map.points.cols() < 2) return std::nullopt;
  if (!(question.confidence > 0.0 && question.confidence < 1.0)) {
    throw std::invalid_argument("confidence is " + number_text(question.confidence) +
                                "; it must lie between 0 and 1");
  }
  const Eigen::Index m = map.points.rows();
  std::vector<Eigen::MatrixXd> positions{};
  // Enough for designs in which half of the draws leave items apart; with fewer there are no regions.
  const std::size_t most = 4 * question.draws;
  for (std::size_t draw = 0; draw < most && positions.size() < question.draws; ++draw) {
    Random draws = random.split("raters").split(static_cast<std::uint64_t>(draw));
    std::vector<RatedPairs> drawn{};
    for (std::size_t s = 0; s < raters.size(); ++s) {
      drawn.push_back(raters[static_cast<std::size_t>(draws.below(raters.size()))]);
    }
    const WeightedDissimilarities mean = mean_of_raters(drawn);
    if (!connects_all_items(mean.weights) || !(mean.values.maxCoeff() > 0.0)) continue;
    const std::optional<Procrustes> aligned =
        procrustes(map.points, scaled_from(map.points, mean, level).points);
    if (aligned) positions.push_back(aligned->fitted.leftCols(2));
  }
  if (positions.size() < question.draws || question.draws < 2) return std::nullopt;
  // P(χ²(2) ≤ x) = 1 − exp(−x/2).
  const double reach = std::sqrt(-2.0 * std::log(1.0 - question.confidence));
  std::vector<PositionRegion> regions{};
  for (Eigen::Index item = 0; item < m; ++item) {
    Eigen::MatrixXd places(static_cast<Eigen::Index>(positions.size()), 2);
    for (std::size_t b = 0; b < positions.size(); ++b)
      places.row(static_cast<Eigen::Index>(b)) = positions[b].row(item);
    const Eigen::MatrixXd centred = places.rowwise() - places.colwise().mean();
    const Eigen::Matrix2d covariance =
        centred.transpose() * centred / static_cast<double>(positions.size() - 1);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(covariance);
    Eigen::Vector2d major = solver.eigenvectors().col(1);
    if (major(0) < 0.0 || (major(0) == 0.0 && major(1) < 0.0)) major = -major;
    regions.push_back({.major = reach * std::sqrt(std::max(0.0, solver.eigenvalues()(1))),
                       .minor = reach * std::sqrt(std::max(0.0, solver.eigenvalues()(0))),
                       .angle_rad = std::atan2(major(1), major(0))});
  }
  return regions;
}

}  // namespace asperity
