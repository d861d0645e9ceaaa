// Tests of choices where the answer can be counted by hand or is published.

#include <cmath>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/choices/decisive_choices.h"
#include "analysis/choices/equal_error_information.h"
#include "analysis/choices/matching_null.h"
#include "analysis/numbers/random.h"
#include "analysis/tests/cochran.h"
#include "analysis/tests/contingency.h"
#include "analysis/tests/pooled_share.h"
#include "analysis/tests/uniform_counts.h"

namespace asperity {
namespace {

// Four participants who always answer alike count as four, not as twelve.
TEST(PooledShare, CountsParticipantsNotAnswers) {
  const std::vector<HitCount> alike{{3, 3}, {3, 3}, {0, 3}, {0, 3}};
  const PooledShare pooled = pooled_share(alike);
  EXPECT_EQ(pooled.share, 0.5);
  EXPECT_NEAR(pooled.design_effect, 3.0 * 4.0 / 3.0, 1e-12);
  EXPECT_THROW(pooled_share({}), std::invalid_argument);
}

// 60 trials of 20 participants without an error: logit 60.5/61 less 2.093 standard errors of 1.420.
TEST(MeanShareInterval, ExistsWhereAllParticipantsAreAlike) {
  const std::vector<HitCount> all_right(20, {3, 3});
  const std::optional<ConfidenceInterval> high = mean_share_interval(all_right);
  EXPECT_NEAR(high.value().low, 0.8610, 5e-4);
  EXPECT_EQ(high->high, 1.0);
  const std::vector<HitCount> all_wrong(20, {0, 3});
  EXPECT_NEAR(mean_share_interval(all_wrong).value().high, 1.0 - high->low, 1e-12);
  EXPECT_EQ(mean_share_interval(all_wrong)->low, 0.0);
  const std::vector<HitCount> alike(5, {2, 4});
  EXPECT_LT(mean_share_interval(alike).value().low, 0.4);
  EXPECT_FALSE(mean_share_interval(std::vector<HitCount>{{2, 4}}).has_value());
}

TEST(MeanShareInterval, RefusesWhatIsNoQuestion) {
  const std::vector<HitCount> two{{1, 2}, {2, 2}};
  EXPECT_THROW(mean_share_interval({}), std::invalid_argument);
  EXPECT_THROW(mean_share_interval(two, {.confidence = 1.0}), std::invalid_argument);
  EXPECT_THROW(mean_share_interval(two, {.least_design_effect = 0.5}), std::invalid_argument);
}

struct SimulatedDesign {
  std::size_t participants = 0;
  std::uint64_t trials = 0;
  double mean_logit = 0.0;  ///< of participants with an SD of 1
  double mean = 0.0;        ///< of their proportions
};

// Six participants whose mean is .95 and 20 with three trials each: Student's interval covers .88 and .85 of them.
TEST(MeanShareInterval, CoversNearOne) {
  constexpr int kStudies = 2000;
  for (const SimulatedDesign& design :
       {SimulatedDesign{20, 3, 3.3714, 0.95}, SimulatedDesign{6, 20, 3.3714, 0.95},
        SimulatedDesign{12, 12, 2.2351, 0.87}}) {
    Random random(5);
    int covered = 0;
    for (int study = 0; study < kStudies; ++study) {
      std::vector<HitCount> own(design.participants, {0, design.trials});
      for (HitCount& one : own) {
        const double p = 1.0 / (1.0 + std::exp(-design.mean_logit - random.normal()));
        for (std::uint64_t trial = 0; trial < design.trials; ++trial) {
          one.hits += random.uniform() < p ? 1 : 0;
        }
      }
      const ConfidenceInterval interval = mean_share_interval(own).value();
      covered += interval.low <= design.mean && design.mean <= interval.high ? 1 : 0;
    }
    EXPECT_GE(covered, 0.94 * kStudies) << design.participants;
    EXPECT_LE(covered, 0.99 * kStudies) << design.participants;
  }
}

// 12, 7 and 1 of 20 against thirds: Σx²·3/20 − 20 = 9.1.
TEST(UniformTest, IsPearsons) {
  const std::vector<std::uint64_t> counts{12, 7, 1};
  EXPECT_NEAR(uniform_test(counts).pearson, 9.1, 1e-12);
  EXPECT_NEAR(uniform_test(counts).pearson_p, std::exp(-9.1 / 2.0),
              1e-12);  // two degrees of freedom
  EXPECT_TRUE(std::isnan(uniform_test(std::vector<std::uint64_t>{0, 0}).pearson));
  EXPECT_THROW(uniform_test(std::vector<std::uint64_t>{3}), std::invalid_argument);
}

// Two conditions: Q is (b − c)²/(b + c) and its exact test is McNemar's.
TEST(CochranTest, IsMcNemarsForTwoConditions) {
  CountMatrix answers(8, 2);
  answers << 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 0, 1, 1, 1, 0, 0;
  const CochranTest test = cochran_test(answers);
  EXPECT_NEAR(test.q, 16.0 / 6.0, 1e-12);
  EXPECT_NEAR(test.exact_p, mcnemar_test({.only_first = 5, .only_second = 1}), 1e-12);
  EXPECT_NEAR(test.exact_p, 14.0 / 64.0, 1e-12);
}

TEST(CochranTest, ComparesNothingWhereEverybodyAnswersAllAlike) {
  const CochranTest test = cochran_test(CountMatrix::Ones(3, 2));
  EXPECT_TRUE(std::isnan(test.q));
  EXPECT_TRUE(std::isnan(test.exact_p));
}

// 2 and 1 of 3: the one may be among the two (1 : 0) or not (2 : 1); both give 1.
TEST(McNemarBounds, WalkOverAllTablesOfTheMargins) {
  const ConfidenceInterval close = mcnemar_bounds({.first = 2, .second = 1, .participants = 3});
  EXPECT_EQ(close.low, 1.0);
  EXPECT_EQ(close.high, 1.0);
  const ConfidenceInterval apart = mcnemar_bounds({.first = 9, .second = 3, .participants = 10});
  EXPECT_NEAR(apart.low, 2.0 / 64.0, 1e-12);     // 6 : 0
  EXPECT_NEAR(apart.high, 18.0 / 256.0, 1e-12);  // 7 : 1, as 9 + 3 − 10 must be in both
  EXPECT_THROW(mcnemar_bounds({.first = 4, .second = 0, .participants = 3}), std::invalid_argument);
}

// Lady tasting tea: 3 of 4 cups right: 34/70 two-sided.
TEST(ExactIndependenceTest, IsFishersForTwoByTwo) {
  CountMatrix table(2, 2);
  table << 3, 1, 1, 3;
  EXPECT_NEAR(*exact_independence_test(table), 34.0 / 70.0, 1e-12);
  EXPECT_EQ(*exact_independence_test(CountMatrix::Zero(2, 3)), 1.0);
  EXPECT_FALSE(exact_independence_test(CountMatrix::Constant(6, 6, 30)));
}

// 36 of 58 decisive choices: 145 of them for 80 %, two-sided.
TEST(DecisiveChoices, WaitsUntilThePowerStays) {
  EXPECT_EQ(decisive_choices({.preference = 36.0 / 58.0}), 145U);
  EXPECT_FALSE(decisive_choices({.preference = 0.5}));
  EXPECT_THROW(decisive_choices({.preference = 1.0}), std::invalid_argument);
}

TEST(EqualErrorBits, AreAllForPerfectionAndNoneForChance) {
  EXPECT_NEAR(equal_error_bits(1.0, 6), std::log2(6.0), 1e-15);
  EXPECT_NEAR(equal_error_bits(1.0 / 6.0, 6), 0.0, 1e-15);
  EXPECT_GT(equal_error_bits(0.0, 6), 0.0);  // never right is no chance either
}

// Felt a, a, b; answered a, b and nothing. Of the six orders of (a, b, –) none, one or two are right.
TEST(ChanceMatches, DealTheTrialsOwnAnswers) {
  const std::vector<MatchedItem> trial{{0, 0}, {0, 1}, {1, {}}};
  // a on one of the first two places and b on the third: 2 orders with 2 right; a first or second
  // with b elsewhere: 2 with 1; a third with b first or second: 2 with none.
  const IntegerDistribution chance = chance_matches(trial);
  EXPECT_NEAR(chance.at(0), 2.0 / 6.0, 1e-15);
  EXPECT_NEAR(chance.at(1), 2.0 / 6.0, 1e-15);
  EXPECT_NEAR(chance.at(2), 2.0 / 6.0, 1e-15);
  EXPECT_FALSE(is_permutation(trial));
  EXPECT_EQ(fixed_points(trial), 1U);
}

TEST(ChanceMatches, AreRencontresForPermutations) {
  const std::vector<MatchedItem> trial{{0, 2}, {1, 0}, {2, 1}, {3, 3}};
  EXPECT_TRUE(is_permutation(trial));
  EXPECT_EQ(chance_matches(trial).probability, fixed_point_distribution(4));
}

}  // namespace
}  // namespace asperity
