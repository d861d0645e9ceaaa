// Orders keep to their limits, are found wherever there is one, and favour none.

#include "protocols/plan/trial_order.h"

#include <algorithm>
#include <map>

namespace asperity {
namespace {

OrderProblem problem_of(const std::vector<std::size_t>& levels, std::size_t maximum,
                        std::size_t group_size) {
  OrderProblem problem{};
  problem.trials = levels.size();
  problem.group_size = group_size;
  problem.limits.push_back({levels, maximum});
  return problem;
}

bool is_permutation_of_all(std::vector<std::size_t> order) {
  std::sort(order.begin(), order.end());
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (order[i] != i) return false;
  }
  return true;
}

TEST(TrialOrder, HoldsEveryLimitOverAThousandSeeds) {
  // 4 × 6 trials, no level twice in a row: a plain shuffle almost never is.
  std::vector<std::size_t> levels{};
  for (std::size_t i = 0; i < 24; ++i) levels.push_back(i % 4);
  const OrderProblem problem = problem_of(levels, 1, 24);
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    const auto order = random_order(problem, Random(seed));
    ASSERT_TRUE(order);
    ASSERT_TRUE(is_permutation_of_all(*order));
    ASSERT_TRUE(meets(problem, *order));
  }
}

TEST(TrialOrder, KeepsRepetitionsTogether) {
  std::vector<std::size_t> levels{};
  for (std::size_t i = 0; i < 12; ++i) levels.push_back(i % 3);
  const OrderProblem problem = problem_of(levels, 1, 3);
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    const auto order = random_order(problem, Random(seed));
    ASSERT_TRUE(order);
    ASSERT_TRUE(meets(problem, *order));
    for (std::size_t i = 0; i < order->size(); ++i) ASSERT_EQ((*order)[i] / 3, i / 3);
  }
}

TEST(TrialOrder, IsFoundEvenWhereOnlyOnePatternIsLeft) {
  // Eleven of one level and ten of the other, never twice: A B A B … A is the only pattern.
  std::vector<std::size_t> levels(21, 0);
  for (std::size_t i = 11; i < 21; ++i) levels[i] = 1;
  const OrderProblem problem = problem_of(levels, 1, 21);
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const auto order = random_order(problem, Random(seed));
    ASSERT_TRUE(order);
    EXPECT_TRUE(meets(problem, *order));
  }
}

TEST(TrialOrder, IsRefusedWhereThereIsNone) {
  std::vector<std::size_t> levels(22, 0);
  for (std::size_t i = 12; i < 22; ++i) levels[i] = 1;  // twelve and ten
  EXPECT_FALSE(random_order(problem_of(levels, 1, 22), Random(1)));
  EXPECT_TRUE(random_order(problem_of(levels, 2, 22), Random(1)));
}

TEST(TrialOrder, MeetsSeveralLimitsAtOnce) {
  // 3 × 2 × 4 trials: the first factor never twice, the second at most twice in a row.
  OrderProblem problem{};
  problem.trials = 24;
  problem.group_size = 24;
  RowLimit first{{}, 1};
  RowLimit second{{}, 2};
  for (std::size_t i = 0; i < 24; ++i) {
    first.level_of_trial.push_back(i % 3);
    second.level_of_trial.push_back((i / 3) % 2);
  }
  problem.limits = {first, second};
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    const auto order = random_order(problem, Random(seed));
    ASSERT_TRUE(order);
    ASSERT_TRUE(meets(problem, *order));
  }
}

TEST(TrialOrder, MeetsIsTheLimitAndNotOneLess) {
  const OrderProblem problem = problem_of({0, 0, 1}, 1, 3);
  EXPECT_FALSE(meets(problem, {0, 1, 2}));
  EXPECT_TRUE(meets(problem, {0, 2, 1}));
  EXPECT_TRUE(meets(problem_of({0, 0, 1}, 2, 3), {0, 1, 2}));
}

TEST(TrialOrder, EveryGoodOrderIsAboutEquallyLikely) {
  // Two As, one B, one C, no level twice in a row: 12 of the 24 orders of the trials are good…
  const OrderProblem problem = problem_of({0, 0, 1, 2}, 1, 4);
  std::map<std::vector<std::size_t>, int> counts{};
  constexpr int kDraws = 12000;
  for (std::uint64_t seed = 0; seed < kDraws; ++seed)
    ++counts[*random_order(problem, Random(seed))];
  EXPECT_EQ(counts.size(), 12U);
  // …each expected 1000 times; 5 standard deviations are 5·√(12000·(1/12)(11/12)) ≈ 151.
  for (const auto& [order, count] : counts) EXPECT_NEAR(count, 1000, 151);
}

TEST(TrialOrder, WithoutLimitsEveryTrialComesAnywhereEquallyOften) {
  OrderProblem problem{};
  problem.trials = 5;
  problem.group_size = 5;
  std::map<std::pair<std::size_t, std::size_t>, int> counts{};
  constexpr int kDraws = 5000;
  for (std::uint64_t seed = 0; seed < kDraws; ++seed) {
    const auto order = *random_order(problem, Random(seed));
    for (std::size_t i = 0; i < order.size(); ++i) ++counts[{order[i], i}];
  }
  // Expected 1000; 5 standard deviations are 5·√(5000·0.2·0.8) ≈ 141.
  for (const auto& [place, count] : counts) EXPECT_NEAR(count, 1000, 141);
}

}  // namespace
}  // namespace asperity
