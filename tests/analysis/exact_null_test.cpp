// Exact null distributions against counting everything, and against published numbers.

#include "analysis/numbers/exact_null.h"

#include <cmath>
#include <numeric>
#include <stdexcept>

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(IntegerDistribution, AddsAsIndependentNumbersDo) {
  const IntegerDistribution die{.lowest = 1, .probability = std::vector<double>(6, 1.0 / 6.0)};
  const IntegerDistribution two = sum_of(die, die);
  EXPECT_EQ(two.lowest, 2);
  EXPECT_NEAR(two.at(7), 6.0 / 36.0, 1e-15);
  EXPECT_NEAR(two.upper_tail(11), 3.0 / 36.0, 1e-15);
  EXPECT_NEAR(two.lower_tail(3), 3.0 / 36.0, 1e-15);
  EXPECT_NEAR(two.mean(), 7.0, 1e-14);
  EXPECT_NEAR(two.variance(), 70.0 / 12.0, 1e-13);
  EXPECT_EQ(two.at(13), 0.0);
  EXPECT_EQ(two.upper_tail(-5), 1.0);
  EXPECT_EQ(two.lower_tail(12), 1.0);
  EXPECT_EQ(two.upper_tail(13), 0.0);
}

TEST(SignFlipTest, CountsEveryPatternOfSigns) {
  const std::vector<std::int64_t> differences{3, -1, 2, 0, 2, -4, 1};
  const std::int64_t observed = std::accumulate(differences.begin(), differences.end(), 0LL);
  int as_large = 0;
  int as_far = 0;
  for (int pattern = 0; pattern < 128; ++pattern) {
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < differences.size(); ++i) {
      sum += (pattern >> i & 1) != 0 ? differences[i] : -differences[i];
    }
    as_large += sum >= observed ? 1 : 0;
    as_far += std::abs(sum) >= std::abs(observed) ? 1 : 0;
  }
  const SignFlipTest test = sign_flip_test(differences);
  EXPECT_NEAR(test.upper, as_large / 128.0, 1e-15);
  EXPECT_NEAR(test.two_sided, as_far / 128.0, 1e-15);
  EXPECT_NEAR(test.smallest, 2.0 / 64.0, 1e-15);  // of six that differ
}

// Half of all patterns are as large as a sum of 1 of an odd number of units, so that both sides are everything;
// with 77 units that sum of doubles was 1 + 2.2e-16.
TEST(SignFlipTest, GivesNoProbabilityAbove1) {
  for (std::size_t units = 1; units <= 301; units += 2) {
    std::vector<std::int64_t> differences(units, 1);
    for (std::size_t i = 0; i < units / 2; ++i) differences[i] = -1;
    const SignFlipTest test = sign_flip_test(differences);
    EXPECT_LE(test.two_sided, 1.0) << units;
    EXPECT_NEAR(test.two_sided, 1.0, 1e-14) << units;
    EXPECT_LE(test.upper, 1.0) << units;
  }
}

// 1500 units of 1000 each, 60 more of them positive than negative: 60/√1500 = 1.55 deviations.
TEST(SignFlipTest, DrawsWhatIsTooMuchToCount) {
  std::vector<std::int64_t> differences(1500, 1000);
  for (std::size_t i = 0; i < 720; ++i) differences[i] = -1000;
  const SignFlipTest test = sign_flip_test(differences);
  EXPECT_FALSE(test.exact);
  EXPECT_NEAR(test.two_sided, 0.1215, 0.02);
  EXPECT_NEAR(test.upper, 0.0608, 0.015);
}

TEST(IntegerDistribution, RepeatsASum) {
  const IntegerDistribution coin{.lowest = 0, .probability = {0.5, 0.5}};
  const IntegerDistribution many = repeated_sum(coin, 4001);
  EXPECT_NEAR(many.mean(), 2000.5, 1e-8);
  EXPECT_NEAR(many.variance(), 1000.25, 1e-6);
  EXPECT_GT(many.lowest, 0);  // 2⁻⁴⁰⁰¹ is no double
  EXPECT_EQ(many.lower_tail(many.lowest - 1), 0.0);
  EXPECT_EQ(repeated_sum(coin, 0).probability, (std::vector<double>{1.0}));
  const IntegerDistribution three = repeated_sum(coin, 3);
  EXPECT_EQ(three.probability, (std::vector<double>{0.125, 0.375, 0.375, 0.125}));
}

TEST(SignFlipTest, SaysNothingWhereNobodyDiffers) {
  const std::vector<std::int64_t> none{0, 0};
  EXPECT_EQ(sign_flip_test(none).two_sided, 1.0);
  EXPECT_EQ(sign_flip_test(none).smallest, 1.0);
  EXPECT_EQ(sign_flip_test(std::vector<std::int64_t>{10}).smallest, 1.0);
  EXPECT_EQ(sign_flip_test({}).upper, 1.0);
  const std::vector<std::int64_t> even{2, -2};
  EXPECT_EQ(sign_flip_test(even).two_sided, 1.0);
}

// Two units (2, 0, 0) and (0, 1, 0): the totals are (3, 0, 0) in 3 of 9 relabellings, sum of squares
// 9, and (2, 1, 0) in the others, 5.
TEST(RelabellingTest, CountsEveryAssignmentOfLabels) {
  CountMatrix counts(2, 3);
  counts << 2, 0, 0, 0, 1, 0;
  EXPECT_NEAR(relabelling_test(counts).p, 1.0, 1e-15);
  EXPECT_NEAR(relabelling_test(counts).smallest, 3.0 / 9.0, 1e-15);
  EXPECT_NEAR(relabelling_test(counts.topRows(1)).smallest, 1.0, 1e-15);
  counts << 2, 0, 0, 1, 0, 0;
  EXPECT_NEAR(relabelling_test(counts).p, 3.0 / 9.0, 1e-15);
  EXPECT_TRUE(relabelling_test(counts).exact);
}

// Of 8 labels, one choice of a person has 8 relabellings and not 8!: 20 persons who all choose the same
// are as far from chance as can be in 8 of 8²⁰.
TEST(RelabellingTest, CountsManyUnitsThatHaveFewRelabellings) {
  CountMatrix counts = CountMatrix::Zero(20, 8);
  counts.col(3).setOnes();
  const RelabellingTest same = relabelling_test(counts);
  EXPECT_TRUE(same.exact);
  EXPECT_NEAR(same.p, std::pow(8.0, -19), 1e-12 * std::pow(8.0, -19));
}

TEST(RelabellingTest, DrawsWhatIsTooMuchToCount) {
  CountMatrix counts = CountMatrix::Zero(16, 8);
  for (Eigen::Index unit = 0; unit < counts.rows(); ++unit) {
    for (Eigen::Index label = 0; label < 8; ++label) counts(unit, label) = (unit + label) % 8;
  }
  const RelabellingTest balanced = relabelling_test(counts);
  EXPECT_FALSE(balanced.exact);
  EXPECT_EQ(balanced.p, 1.0);  // all totals are equal: nothing is less extreme
  counts.rowwise() = counts.row(0).eval();
  const RelabellingTest extreme = relabelling_test(counts);
  EXPECT_EQ(extreme.drawn, 99'999U);
  EXPECT_NEAR(extreme.p, 1e-5, 1e-12);  // nothing drawn is as extreme
}

TEST(RelabellingTest, RefusesWhatIsNoCount) {
  EXPECT_THROW(relabelling_test(CountMatrix(2, 0)), std::invalid_argument);
  EXPECT_THROW(relabelling_test(CountMatrix::Constant(1, 2, -1)), std::invalid_argument);
}

// 12, 7 and 1 of 20: 0.0061 in the order of probability, 0.0136 in that of Pearson's X².
TEST(UniformMultinomialTest, HasTwoOrders) {
  const std::vector<std::uint64_t> counts{12, 7, 1};
  const MultinomialTest test = uniform_multinomial_test(counts);
  EXPECT_NEAR(test.by_probability, 0.0061, 0.00005);
  EXPECT_NEAR(test.by_chi_squared, 0.0136, 0.00005);
}

// Of two alternatives both orders are the two-sided binomial test: 2·(1 + 10)/2¹⁰ for 1 of 10.
TEST(UniformMultinomialTest, IsTheBinomialTestForTwo) {
  const std::vector<std::uint64_t> counts{1, 9};
  EXPECT_NEAR(uniform_multinomial_test(counts).by_probability, 22.0 / 1024.0, 1e-15);
  EXPECT_NEAR(uniform_multinomial_test(counts).by_chi_squared, 22.0 / 1024.0, 1e-15);
}

TEST(UniformMultinomialTest, SaysWhenThereIsTooMuchToCount) {
  const std::vector<std::uint64_t> counts(10, 100);
  EXPECT_FALSE(uniform_multinomial_test(counts).counted);
}

}  // namespace
}  // namespace asperity
