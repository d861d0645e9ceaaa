// Compares the ROC of ratings with hand computation, with the yes/no model and with the truth of simulated observers.

#include "analysis/choices/rating_roc.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/choices/signal_detection.h"
#include "analysis/numbers/random.h"
#include "analysis/tests/participant_bootstrap.h"

namespace asperity {
namespace {

// Pairs of a signal and a noise trial: 1·(½·2) + 2·(2 + ½·1) + 1·3 = 9 of 12, with the signal rated higher, ties half.
TEST(RatingRoc, AreaIsTheProportionOfPairsInOrder) {
  const std::vector<RatingCount> ratings{{2, 1}, {1, 2}, {0, 1}};
  EXPECT_DOUBLE_EQ(roc_area(ratings).area, 9.0 / 12.0);
  const std::vector<RocPoint> points = roc_points(ratings);
  ASSERT_EQ(points.size(), 2U);
  EXPECT_DOUBLE_EQ(points[0].false_alarm, 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(points[0].hit, 3.0 / 4.0);
  EXPECT_DOUBLE_EQ(points[1].hit, 1.0 / 4.0);
}

TEST(RatingRoc, OfTwoRatingsIsTheYesNoModel) {
  const std::vector<RatingCount> ratings{{38, 8}, {12, 42}};
  const auto fit = fit_roc(ratings, RocVariance::equal);
  const auto expected = yes_no_sensitivity(
      observed_rates({.signal = {.hits = 42, .trials = 50}, .noise = {.hits = 12, .trials = 50}}));
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->mean, expected->dprime, 1e-8);
  EXPECT_NEAR(fit->mean_error, expected->standard_error, 1e-8);
  EXPECT_NEAR(fit->criteria.front(), expected->criterion + 0.5 * expected->dprime, 1e-8);
  EXPECT_FALSE(fit_roc(ratings, RocVariance::free));
}

/// Ratings of an observer with the criteria −1, 0, 1, 2, signals with mean 1.2 and standard deviation 1.4.
std::vector<RatingCount> simulated_ratings(int trials, Random& random) {
  constexpr std::array kCriteria{-1.0, 0.0, 1.0, 2.0};
  std::vector<RatingCount> ratings(kCriteria.size() + 1);
  const auto rating_of = [&](double impression) {
    return static_cast<std::size_t>(
        std::upper_bound(kCriteria.begin(), kCriteria.end(), impression) - kCriteria.begin());
  };
  for (int trial = 0; trial < trials; ++trial) {
    ++ratings[rating_of(random.normal())].noise;
    ++ratings[rating_of(1.2 + 1.4 * random.normal())].signal;
  }
  return ratings;
}

TEST(RatingRoc, RecoversTheModelOfManyTrials) {
  Random random(3);
  const auto fit = fit_roc(simulated_ratings(100'000, random), RocVariance::free);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->mean, 1.2, 4.0 * fit->mean_error);
  EXPECT_NEAR(fit->deviation, 1.4, 4.0 * fit->deviation_error);
  EXPECT_NEAR(fit->criteria[3], 2.0, 0.03);
  EXPECT_LT(fit->mean_error, 0.01);
}

TEST(RatingRoc, HasTheStandardErrorsOfSimulatedObservers) {
  Random random(5);
  std::vector<double> deviations{};
  double errors = 0.0;
  for (int observer = 0; observer < 400; ++observer) {
    const auto fit = fit_roc(simulated_ratings(300, random), RocVariance::free);
    ASSERT_TRUE(fit);
    deviations.push_back(std::log(fit->deviation));
    errors += fit->deviation_error / fit->deviation;
  }
  double mean = 0.0;
  for (const double each : deviations) mean += each / 400.0;
  double variance = 0.0;
  for (const double each : deviations) variance += (each - mean) * (each - mean) / 399.0;
  EXPECT_NEAR(errors / 400.0 / std::sqrt(variance), 1.0, 0.11);  // three standard errors
}

TEST(RatingRoc, HasNoFiniteMaximumWhereRatingsSeparateTheTrials) {
  EXPECT_FALSE(fit_roc(std::vector<RatingCount>{{20, 0}, {0, 20}}, RocVariance::equal));
  EXPECT_FALSE(fit_roc(std::vector<RatingCount>{{20, 0}, {5, 0}, {0, 20}}, RocVariance::free));
}

TEST(RatingRoc, LeavesOutARatingThatIsNeverGiven) {
  const auto with =
      fit_roc(std::vector<RatingCount>{{30, 8}, {0, 0}, {20, 20}, {10, 32}}, RocVariance::free);
  const auto without =
      fit_roc(std::vector<RatingCount>{{30, 8}, {20, 20}, {10, 32}}, RocVariance::free);
  ASSERT_TRUE(with && without);
  EXPECT_DOUBLE_EQ(with->mean, without->mean);
  EXPECT_EQ(with->criteria, (std::vector<double>{without->criteria[0], without->criteria[0],
                                                 without->criteria[1]}));
}

TEST(RatingRoc, NeedsTrialsOfBothKinds) {
  EXPECT_THROW(roc_area(std::vector<RatingCount>{{3, 0}, {2, 0}}), std::invalid_argument);
}

// Participants whose trials agree: an interval from single trials would be √10 shorter.
TEST(ParticipantBootstrap, ResamplesParticipantsWithAllTheirTrials) {
  const std::vector<double> means{0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0};
  const auto mean_of = [&](std::span<const std::size_t> places) -> std::optional<double> {
    double sum = 0.0;
    for (const std::size_t place : places) sum += means[place];
    return sum / static_cast<double>(places.size());
  };
  const ParticipantBootstrap found = bootstrap_participants({.participants = 10}, mean_of);
  ASSERT_TRUE(found.interval);
  // The interval of the t test: 0.55 ± 2.2622·√(0.0916667/10).
  EXPECT_NEAR(found.interval->low, 0.3334, 0.015);
  EXPECT_NEAR(found.interval->high, 0.7666, 0.015);
  EXPECT_EQ(found.without, 0U);
  EXPECT_TRUE(bootstrap_participants({.participants = 6}, mean_of).interval);
  EXPECT_FALSE(bootstrap_participants({.participants = 5}, mean_of).interval);
}

}  // namespace
}  // namespace asperity
