// Dissimilarities that several raters judged: their mean, its stress by chance, the number of dimensions, and how far
// positions depend on the raters.

#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "analysis/dissimilarity/multidimensional_scaling.h"
#include "analysis/numbers/random.h"
#include "analysis/numbers/seed_of_tests.h"

namespace asperity {

/// One rater's mean judgement of every pair, and the number of judgements: 0 where the pair was not judged.
using RatedPairs = WeightedDissimilarities;

/// Means from sums: `sums` has, for each pair i < j, the sum of its judgements and as its weight their number. A pair
/// without a judgement keeps the weight 0; the result is symmetric.
RatedPairs means_of_sums(RatedPairs sums);

/// The mean over the raters who judged a pair; its weight is their number. Throws std::invalid_argument for no rater
/// and for different numbers of items.
WeightedDissimilarities mean_of_raters(std::span<const RatedPairs> raters);

/// Pearson's correlation of each rater's judgements with the mean of the others', over the pairs that they share;
/// nothing where there are fewer than three or one of the two is constant.
std::vector<std::optional<double>> agreement_with_others(std::span<const RatedPairs> raters);

/// P(stress ≤ the observed one) when raters' judgements have no relation to the pairs: each rater's judgements are
/// permuted over the pairs that the rater judged, their mean is scaled in the same manner as the observed one, and the observed
/// stress counts as one of the permutations. A level of stress alone shows nothing: it grows with the number of items and
/// falls with that of dimensions, whatever the judgements are [Spence 1973].
///
/// p = (1 + #{permutations: stress ≤ max(observed, kPerfectStress)}) / (permutations + 1). The statistic is max(stress, kPerfectStress):
/// stresses of perfect fits differ only by what the steps of a fit leave of 0, and are ties. If each rater's judgements are
/// exchangeable over the pairs, independently of those of the other raters, the ratings and their permutations are exchangeable, and
/// the statistic is the same function of all of them (the random starts are the same). The observed one then has every rank with
/// the same probability, ties count against it, and P(p ≤ α) ≤ α for any number of permutations. This is approximate if a rater's
/// means are of different numbers of judgements, and if the number of dimensions or the level was chosen by the same ratings.
///
/// [Spence 1973] Spence, Ogilvie: A table of expected stress values for random rankings in nonmetric multidimensional scaling.
struct StressByChance {
  double observed =
      0.0;            ///< with the starts of this test, which are fewer than those of a final fit
  double mean = 0.0;  ///< of the permutations
  double p05 = 0.0;   ///< their 5 % quantile (type 7)
  double p = 1.0;
  std::size_t drawn = 0;
  std::size_t perfect = 0;  ///< permutations with a perfect fit

  /// That of ratings with a perfect fit.
  double smallest_p() const {
    return static_cast<double>(perfect + 1) / static_cast<double>(drawn + 1);
  }
  /// Whether there are ratings for which the test can be significant. Few items suffice for the contrary: the order of the
  /// dissimilarities of m items, without ties, has a perfect fit in m − 2 dimensions. A constant added to all of them keeps their
  /// order, and the smallest one that makes them Euclidean distances makes them distances in at most m − 2 dimensions.
  ///
  /// A test that is omitted here would not have been significant. The Type I error rate of all studies is thus unchanged; that
  /// of the studies with a test is greater, by at most the factor of their reciprocal proportion.
  bool can_be_significant() const { return smallest_p() <= 0.05; }
  static constexpr double kPerfectStress = 1e-3;  ///< what is up to it is left of a stress of 0
};
struct ChanceQuestion {
  Eigen::Index dimensions = 2;
  std::size_t permutations = 199;
  std::size_t random_starts = 4;  ///< of each fit
  ScalingLevel level = ScalingLevel::ordinal;
};
StressByChance stress_by_chance(std::span<const RatedPairs> raters,
                                const ChanceQuestion& question = {},
                                const Random& random = Random(kSeedOfTests));

/// For R dimensions, each rater's judgements are predicted from the others: the mean of the others is scaled in R dimensions, their
/// mean judgements are regressed on the distances (isotonic regression), and the rater's judgements of the same
/// pairs are compared with the result. Dimensions that only fit the noise of some raters predict others worse.
struct DimensionError {
  Eigen::Index dimensions = 1;
  double error = 0.0;       ///< root mean square over raters and pairs, in the unit of the scale
  double above_best = 0.0;  ///< the mean over raters of their mean square minus that of the best R
  double above_best_se = 0.0;  ///< its standard error
};
struct DimensionChoice {
  std::vector<DimensionError> errors{};  ///< by R, from 1
  /// The fewest dimensions whose error does not exceed the smallest one by more than one standard error of the
  /// difference.
  Eigen::Index chosen = 1;
};
/// `maps`: the configurations of all raters in 1, 2, … dimensions, from which the fits start. Nothing for fewer than three
/// raters, and where the others of a rater do not connect all items.
std::optional<DimensionChoice> dimensions_by_cross_validation(
    std::span<const RatedPairs> raters, std::span<const Configuration> maps,
    ScalingLevel level = ScalingLevel::ordinal);

/// The number of different disparities of a configuration; those that differ by less than 1 % of the largest one count as one.
///
/// If all dissimilarities within clusters are below all others, non-metric scaling has a perfect solution in which each cluster is
/// one point and all others have one distance, whatever the sizes of the dissimilarities: it is degenerate [Kruskal 1978].
std::size_t different_disparities(const WeightedDissimilarities& given, const Configuration& map);
/// At most so many different disparities are those of a degenerate configuration.
constexpr std::size_t kDisparitiesOfDegenerate = 3;

/// The items on one point of a non-metric configuration, in ascending order: the most that lie within 1 % of the largest distance of
/// one of them; empty for fewer than three. Non-metric scaling can collapse a part of the items whose dissimilarities are below those to
/// all others: its stress then does not depend on the dissimilarities within that part. Pairs whose dissimilarity is at most 1 % of the
/// largest one lie rightly on one point and do not count.
std::vector<Eigen::Index> collapsed_items(const WeightedDissimilarities& given,
                                          const Configuration& map);

/// How much an item's position would vary with other raters: raters are drawn with replacement, their mean is scaled from the
/// configuration of all raters, and the result is brought onto that configuration (procrustes). The region is the ellipse of the
/// first two dimensions that contains the given fraction of a normal distribution with the covariance of these positions.
struct PositionRegion {
  double major = 0.0;  ///< half axes, in the unit of the configuration
  double minor = 0.0;
  double angle_rad = 0.0;  ///< of the major axis, from the first dimension towards the second
};
struct BootstrapQuestion {
  std::size_t draws = 500;
  double confidence = 0.95;
};
/// Nothing for fewer than three raters and for one dimension. Draws whose pairs do not connect all items are drawn again.
std::optional<std::vector<PositionRegion>> bootstrap_regions(
    std::span<const RatedPairs> raters, const Configuration& map, ScalingLevel level,
    const BootstrapQuestion& question = {}, const Random& random = Random(kSeedOfTests));

}  // namespace asperity
