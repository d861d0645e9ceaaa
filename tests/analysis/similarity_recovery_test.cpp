// How well studies of similarity restore a known plane, and how often guessing looks like one.

#include <algorithm>
#include <iostream>

#include <gtest/gtest.h>

#include "analysis/dissimilarity/procrustes.h"
#include "tests/analysis/simulated_raters.h"

namespace asperity {
namespace {

constexpr std::size_t kStudies = 200;
constexpr Eigen::Index kTextures = 12;
/// A configuration in the plane fits about 1.4 % of the permuted ratings of so few perfectly.
constexpr Eigen::Index kFewTextures = 7;

// 12 textures, 10 raters, one judgement of each of the 66 pairs.
TEST(SimilarityRecovery, RestoresThePlane) {
  std::vector<double> r_squared{};
  std::size_t two_dimensions = 0;
  for (std::size_t study = 0; study < kStudies; ++study) {
    const Random random = Random(1000).split(static_cast<std::uint64_t>(study));
    const Eigen::MatrixXd plane = drawn_plane(kTextures, random.split("plane"));
    const std::vector<RatedPairs> raters = judged_by({}, plane, random.split("raters"));
    const WeightedDissimilarities mean = mean_of_raters(raters);
    std::vector<Configuration> maps{};
    for (Eigen::Index r = 1; r <= 5; ++r) maps.push_back(scaled(mean, {.dimensions = r}));
    r_squared.push_back(procrustes(plane, maps[1].points)->r_squared);
    if (dimensions_by_cross_validation(raters, maps)->chosen == 2) ++two_dimensions;
  }
  std::sort(r_squared.begin(), r_squared.end());
  const double median = r_squared[kStudies / 2];
  const double p05 = r_squared[kStudies / 20];
  std::cout << "Procrustes r² over " << kStudies << " studies: median " << median
            << ", 5 % quantile " << p05 << "; two dimensions chosen in " << two_dimensions << '\n';
  EXPECT_GE(median, 0.97);
  EXPECT_GE(p05, 0.95);
  EXPECT_GE(two_dimensions, 180U);
}

// With 39 permutations, p ≤ .05 occurs with probability 2/40 if nothing but chance is at work: of 200 studies 10, and
// more than 21 with a probability below 0.0005 (binomial).
TEST(SimilarityRecovery, FindsNoConfigurationInGuesses) {
  for (const Eigen::Index textures : {kTextures, kFewTextures}) {
    std::size_t significant = 0;
    for (std::size_t study = 0; study < kStudies; ++study) {
      const Random random = Random(2000).split(static_cast<std::uint64_t>(study));
      const Eigen::MatrixXd plane = drawn_plane(textures, random.split("plane"));
      const StressByChance stress =
          stress_by_chance(judged_by({.guess = true}, plane, random.split("raters")),
                           {.permutations = 39, .random_starts = 2}, random.split("permutations"));
      if (stress.p <= 0.05) ++significant;
    }
    std::cout << textures << " textures: p ≤ .05 in " << significant << " of " << kStudies
              << " studies of guesses\n";
    EXPECT_LE(significant, 21U) << textures;
  }
}

}  // namespace
}  // namespace asperity
