// The gates in full: at least four thousand trials of each kind, pooled over five seeds.

#include "tests/gates/gate_checks.h"

namespace asperity {
namespace {

const std::vector<std::uint64_t> kSeeds{11, 22, 33, 44, 55};

// 99.9 % quantiles of χ² with 5 and with 25 degrees of freedom.
constexpr double kOf5 = 20.52;
constexpr double kOf25 = 52.62;

TEST(DeafObserverInThousands, PrefersNoModel) {
  SimulatedStudy study;
  const GateCounts counts = study.run({"chapter_selection", GateObserver::deaf, 30, 9, kSeeds, {}});
  ASSERT_GE(counts.trials, 4000U);
  expect_no_model_preferred(counts, kGateMargin);
  expect_all_marked_as_guesses(counts);

  // The surfaces came in every order alike, and one trial's order tells nothing of the next one's.
  ASSERT_EQ(counts.orders.size(), 6U);
  const double of_orders = chi_square_of_equal(counts.orders, 6);
  EXPECT_LT(of_orders, kOf5);
  std::map<std::string, double> first{};
  std::map<std::string, double> second{};
  double pairs = 0.0;
  for (const auto& [pair, times] : counts.order_pairs) {
    first[pair.first] += static_cast<double>(times);
    second[pair.second] += static_cast<double>(times);
    pairs += static_cast<double>(times);
  }
  double of_pairs = 0.0;
  for (const auto& [one, one_times] : first) {
    for (const auto& [next, next_times] : second) {
      const double expected = one_times * next_times / pairs;
      const auto found = counts.order_pairs.find({one, next});
      const double times =
          found == counts.order_pairs.end() ? 0.0 : static_cast<double>(found->second);
      of_pairs += (times - expected) * (times - expected) / expected;
    }
  }
  EXPECT_LT(of_pairs, kOf25);
  std::cout << "orders: chi-square " << of_orders << " of 5, consecutive ones: " << of_pairs
            << " of 25\n";
}

TEST(DeafObserverInThousands, MatchesByChance) {
  SimulatedStudy study;
  const GateCounts counts =
      study.run({"improved_matching", GateObserver::deaf, 100, 8, kSeeds, {}});
  ASSERT_GE(counts.trials, 4000U);
  expect_items_by_chance(counts, 4, kGateMargin);
  expect_by_chance("matched wholly", {counts.whole, counts.trials}, whole_chance(4), kGateMargin);
  expect_all_marked_as_guesses(counts);
}

TEST(DeafObserverInThousands, RecognisesByChance) {
  SimulatedStudy study;
  const GateCounts counts =
      study.run({"improved_recognition", GateObserver::deaf, 20, 10, kSeeds, {}});
  ASSERT_GE(counts.trials, 4000U);
  expect_by_chance("recognised", {counts.right, counts.trials}, 1.0 / 6.0, kGateMargin);
  expect_all_marked_as_guesses(counts);
}

TEST(NoiselessObserverInThousands, MatchesMostItems) {
  SimulatedStudy study;
  const GateCounts counts =
      study.run({"improved_matching", GateObserver::noiseless, 100, 8, kSeeds, {}});
  ASSERT_GE(counts.trials, 4000U);
  expect_most_items_right("matched", counts);
}

TEST(NoiselessObserverInThousands, RecognisesMostItems) {
  SimulatedStudy study;
  const GateCounts counts =
      study.run({"improved_recognition", GateObserver::noiseless, 20, 10, kSeeds, {}});
  ASSERT_GE(counts.trials, 4000U);
  expect_most_items_right("recognised", counts);
}

}  // namespace
}  // namespace asperity
