// Raters with a known configuration, and raters who guess.

#include "analysis/dissimilarity/rated_dissimilarities.h"

#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/dissimilarity/individual_differences.h"
#include "analysis/dissimilarity/procrustes.h"
#include "tests/analysis/simulated_raters.h"

namespace asperity {
namespace {

constexpr Eigen::Index kItems = 12;

TEST(RatedDissimilarities, AverageTheRatersOfAPair) {
  RatedPairs first{.values = Dissimilarities::Zero(3, 3), .weights = Eigen::MatrixXd::Zero(3, 3)};
  RatedPairs second = first;
  const auto judge = [](RatedPairs& rater, Eigen::Index i, Eigen::Index j, double value) {
    rater.values(i, j) = rater.values(j, i) = value;
    rater.weights(i, j) = rater.weights(j, i) = 1.0;
  };
  judge(first, 0, 1, 2.0);
  judge(second, 0, 1, 4.0);
  judge(second, 1, 2, 5.0);
  const std::vector raters{first, second};
  const WeightedDissimilarities mean = mean_of_raters(raters);
  EXPECT_EQ(mean.values(1, 0), 3.0);
  EXPECT_EQ(mean.weights(0, 1), 2.0);
  EXPECT_EQ(mean.values(1, 2), 5.0);
  EXPECT_EQ(mean.weights(0, 2), 0.0);
}

// The small set of the studies of similarity_recovery_test.cpp.
TEST(RatedDissimilarities, RestoreTheConfigurationAndItsDimensions) {
  for (std::uint64_t study = 0; study < 2; ++study) {
    const Random random = Random(100).split(study);
    const Eigen::MatrixXd plane = drawn_plane(kItems, random.split("plane"));
    const std::vector<RatedPairs> raters = judged_by({}, plane, random.split("raters"));
    const WeightedDissimilarities mean = mean_of_raters(raters);
    std::vector<Configuration> maps{};
    for (Eigen::Index r = 1; r <= 4; ++r)
      maps.push_back(scaled(mean, {.dimensions = r, .random_starts = 5}));
    EXPECT_GT(procrustes(plane, maps[1].points)->r_squared, 0.95) << study;
    EXPECT_EQ(dimensions_by_cross_validation(raters, maps)->chosen, 2) << study;
  }
}

// Items 0 to 2 on one point, and item 3 at a distance.
TEST(RatedDissimilarities, CollapseItemsThatDifferAndNotThoseThatAreAlike) {
  Configuration map{.points = Eigen::MatrixXd::Zero(4, 2)};
  map.points(3, 0) = 1.0;
  map.points(2, 1) = 0.009;
  WeightedDissimilarities given{.values = Dissimilarities::Constant(4, 4, 80.0),
                                .weights = Eigen::MatrixXd::Ones(4, 4)};
  given.values.topLeftCorner(3, 3).setConstant(5.0);
  EXPECT_THAT(collapsed_items(given, map), testing::ElementsAre(0, 1, 2));
  map.points(2, 1) = 0.02;
  EXPECT_THAT(collapsed_items(given, map), testing::IsEmpty()) << "two are no part of the items";
  map.points(2, 1) = 0.0;
  given.values.topLeftCorner(3, 3).setConstant(0.8);  // of 80
  EXPECT_THAT(collapsed_items(given, map), testing::IsEmpty()) << "they were judged alike";
}

TEST(RatedDissimilarities, HaveAStressBelowThatOfPermutedOnes) {
  const Eigen::MatrixXd plane = drawn_plane(kItems, Random(21));
  const ChanceQuestion question{.permutations = 19, .random_starts = 1};
  const StressByChance real = stress_by_chance(judged_by({}, plane, Random(22)), question);
  EXPECT_EQ(real.p, 1.0 / 20.0);
  EXPECT_LT(real.observed, real.p05);
  // Of guesses each p is .1, .2, … 1 with equal probability; more than 3 of 6 are .1 with a probability of 0.0013.
  int smallest = 0;
  for (std::uint64_t study = 0; study < 6; ++study) {
    const StressByChance guessed =
        stress_by_chance(judged_by({.guess = true}, plane, Random(23).split(study)),
                         {.permutations = 9, .random_starts = 1});
    if (guessed.p <= 0.1) ++smallest;
  }
  EXPECT_LE(smallest, 3);
}

// Seven items have a perfect fit in the plane in a few permutations: these are ties of ratings that are distances in a plane.
TEST(RatedDissimilarities, CountPermutationsThatFitPerfectlyAsTies) {
  const std::vector<RatedPairs> exact =
      judged_by({.number = 4, .weight_log_sd = 0.0, .power_log_sd = 0.0, .noise = 0.0},
                drawn_plane(7, Random(61)), Random(61));
  const StressByChance stress = stress_by_chance(exact, {.permutations = 99});
  EXPECT_LT(stress.observed, 1e-6);
  EXPECT_GT(stress.p05, 0.01) << "other permutations do not fit";
  EXPECT_EQ(stress.p, 0.04) << "and not 0.01: three permutations fit as well";
  EXPECT_EQ(stress.p, stress.smallest_p());
  EXPECT_TRUE(stress.can_be_significant());
}

TEST(RatedDissimilarities, AreTestedWhereTheSmallestPIsSignificant) {
  EXPECT_TRUE((StressByChance{.drawn = 199, .perfect = 9}.can_be_significant()));
  EXPECT_FALSE((StressByChance{.drawn = 199, .perfect = 10}.can_be_significant()));
  EXPECT_FALSE((StressByChance{.drawn = 9, .perfect = 0}.can_be_significant()));
}

// Half of the noise, half of the half axes: the regions come from the raters and not from the configuration.
TEST(RatedDissimilarities, HaveSmallerRegionsWithLessNoise) {
  const Eigen::MatrixXd plane = drawn_plane(kItems, Random(31));
  const auto mean_major = [&](double noise) {
    const std::vector<RatedPairs> raters =
        judged_by({.weight_log_sd = 0.0, .power_log_sd = 0.0, .noise = noise}, plane, Random(32));
    const Configuration map = scaled(mean_of_raters(raters), {.random_starts = 3});
    double sum = 0.0;
    const auto regions = bootstrap_regions(raters, map, ScalingLevel::ordinal, {.draws = 60});
    for (const PositionRegion& region : *regions) {
      EXPECT_GE(region.major, region.minor);
      sum += region.major;
    }
    return sum / kItems;
  };
  const double wide = mean_major(0.1);
  EXPECT_NEAR(mean_major(0.05) / wide, 0.5, 0.2);
}

TEST(RatedDissimilarities, AgreeWithTheOthersUnlessTheyGuess) {
  const Eigen::MatrixXd plane = drawn_plane(kItems, Random(41));
  std::vector<RatedPairs> raters = judged_by({.number = 5}, plane, Random(42));
  raters.push_back(judged_by({.number = 1, .guess = true}, plane, Random(43)).front());
  const std::vector<std::optional<double>> agreement = agreement_with_others(raters);
  for (std::size_t s = 0; s < 5; ++s) EXPECT_GT(*agreement[s], 0.5) << s;
  EXPECT_LT(std::abs(*agreement[5]), 0.4);
}

// Without noise the scalar products are exactly X·W·Xᵀ: weights, up to each rater's own scale, and axes are restored.
TEST(IndividualDifferences, RestoreTheWeightsOfExactJudgements) {
  Eigen::MatrixXd points = drawn_plane(8, Random(51));
  points.rowwise() -= points.colwise().mean().eval();
  Eigen::MatrixXd weights(4, 2);
  weights << 2.0, 0.5, 1.0, 1.0, 0.3, 1.8, 1.0, 0.2;
  std::vector<Dissimilarities> raters{};
  for (Eigen::Index s = 0; s < 4; ++s) {
    const Eigen::RowVectorXd stretch = weights.row(s).cwiseSqrt();
    raters.push_back(distances_between(points * stretch.asDiagonal()));
  }
  const std::optional<IndividualDifferences> found = individual_differences(raters, 2);
  EXPECT_NEAR(found->total_fit, 1.0, 1e-9);
  // Axis a has the sum of squares c_a, which the unit of the fitted axes moves to the weights.
  const Eigen::RowVectorXd size = points.colwise().squaredNorm();
  const bool swapped = std::abs(found->points.col(0).dot(points.col(0).normalized())) < 0.9;
  for (Eigen::Index s = 0; s < 4; ++s) {
    const double expected = weights(s, 0) * size(0) / (weights(s, 1) * size(1));
    const double ratio = found->weights(s, swapped ? 1 : 0) / found->weights(s, swapped ? 0 : 1);
    EXPECT_NEAR(ratio / expected, 1.0, 1e-4) << s;
  }
}

}  // namespace
}  // namespace asperity
