// Compares sensitivities and their errors with closed forms, with simulated observers and with each other.

#include "analysis/choices/signal_detection.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "analysis/choices/decision_rules.h"
#include "analysis/choices/forced_choice.h"
#include "analysis/numbers/random.h"
#include "analysis/numbers/tail_probabilities.h"

namespace asperity {
namespace {

/// Rates of an observer of the yes/no model.
DetectionRates rates_of(double dprime, double criterion) {
  return {.hit = normal_below(0.5 * dprime - criterion),
          .false_alarm = normal_below(-0.5 * dprime - criterion),
          .signal_trials = 100.0,
          .noise_trials = 100.0};
}

TEST(SignalDetection, ReturnsTheSensitivityAndTheCriterionOfTheModel) {
  for (const double dprime : {-0.7, 0.0, 1.3, 3.0}) {
    for (const double criterion : {-0.8, 0.0, 0.4}) {
      const auto found = yes_no_sensitivity(rates_of(dprime, criterion));
      ASSERT_TRUE(found);
      EXPECT_NEAR(found->dprime, dprime, 1e-12);
      EXPECT_NEAR(found->criterion, criterion, 1e-12);
      EXPECT_NEAR(found->log_beta(), criterion * dprime, 1e-12);
    }
  }
}

// Without bias H = Φ(d′/√2), the proportion correct of two-alternative forced choice.
TEST(SignalDetection, AgreesWithForcedChoiceWithoutBias) {
  for (const double dprime : {0.2, 1.0, 2.5}) {
    const double correct = ForcedChoice{.alternatives = 2}.share(dprime);
    const auto found = two_alternative_sensitivity({.hit = correct,
                                                    .false_alarm = 1.0 - correct,
                                                    .signal_trials = 50.0,
                                                    .noise_trials = 50.0});
    EXPECT_NEAR(found->dprime, dprime, 1e-10);
    EXPECT_NEAR(found->criterion, 0.0, 1e-12);
  }
}

TEST(SignalDetection, HasNoFiniteSensitivityAtAnExtremeRateAndAFiniteOneAfterTheCorrection) {
  const DetectionCounts counts{.signal = {.hits = 20, .trials = 20},
                               .noise = {.hits = 4, .trials = 20}};
  EXPECT_FALSE(yes_no_sensitivity(observed_rates(counts)));
  const DetectionRates corrected = loglinear_rates(counts);
  EXPECT_DOUBLE_EQ(corrected.hit, 20.5 / 21.0);
  EXPECT_DOUBLE_EQ(corrected.false_alarm, 4.5 / 21.0);
  EXPECT_DOUBLE_EQ(corrected.signal_trials, 21.0);
  EXPECT_TRUE(yes_no_sensitivity(corrected));
}

TEST(SignalDetection, RefusesCountsWithoutTrials) {
  EXPECT_THROW(loglinear_rates({.signal = {.hits = 1, .trials = 2}}), std::invalid_argument);
  EXPECT_THROW(observed_rates({.signal = {.hits = 1, .trials = 2}}), std::invalid_argument);
  EXPECT_THROW(
      loglinear_rates({.signal = {.hits = 3, .trials = 2}, .noise = {.hits = 0, .trials = 1}}),
      std::invalid_argument);
}

std::uint64_t binomial_count(std::uint64_t trials, double probability, Random& random) {
  std::uint64_t hits = 0;
  for (std::uint64_t i = 0; i < trials; ++i) hits += random.uniform() < probability ? 1 : 0;
  return hits;
}

// The delta method holds for many trials: 400 of each kind, 2000 observers. The SD of an SD from 2000 observers is 1.6 %.
TEST(SignalDetection, HasTheStandardErrorOfSimulatedObservers) {
  const DetectionRates truth = rates_of(1.0, 0.3);
  constexpr std::uint64_t kTrials = 400;
  constexpr int kObservers = 2000;
  Random random(1);
  double sum = 0.0;
  double squares = 0.0;
  double errors = 0.0;
  for (int observer = 0; observer < kObservers; ++observer) {
    const DetectionCounts counts{
        .signal = {.hits = binomial_count(kTrials, truth.hit, random), .trials = kTrials},
        .noise = {.hits = binomial_count(kTrials, truth.false_alarm, random), .trials = kTrials}};
    const auto found = two_alternative_sensitivity(loglinear_rates(counts));
    sum += found->dprime;
    squares += found->dprime * found->dprime;
    errors += found->standard_error;
  }
  const double mean = sum / kObservers;
  const double deviation = std::sqrt(squares / kObservers - mean * mean);
  EXPECT_NEAR(mean, 1.0 / std::numbers::sqrt2, 0.01);
  EXPECT_NEAR(errors / kObservers / deviation, 1.0, 0.05);
}

/// The proportion of an observer who receives normal impressions and decides by a rule.
template <class Decides>
double simulated(int trials, const Decides& decides) {
  Random random(7);
  int count = 0;
  for (int trial = 0; trial < trials; ++trial) count += decides(random) ? 1 : 0;
  return static_cast<double>(count) / trials;
}

constexpr int kSimulatedTrials = 200'000;  // a proportion has a standard error of at most 0.0011
constexpr double kSimulatedReach = 0.0045;

TEST(DecisionRules, SameDifferentByDifferencingIsWhatSuchAnObserverDoes) {
  constexpr double kDprime = 1.4;
  constexpr double kCriterion = 1.1;
  const auto responds_different = [](double distance) {
    return [distance](Random& random) {
      return std::abs(random.normal() - (random.normal() + distance)) > kCriterion;
    };
  };
  const double hit = simulated(kSimulatedTrials, responds_different(kDprime));
  const double false_alarm = simulated(kSimulatedTrials, responds_different(0.0));
  EXPECT_NEAR(same_different_criterion(false_alarm), kCriterion, 0.01);
  EXPECT_NEAR(same_different_hit_rate(kDprime, false_alarm, DecisionRule::differencing), hit,
              kSimulatedReach);
  const auto found = same_different_sensitivity(
      {.hit = hit, .false_alarm = false_alarm, .signal_trials = 1e5, .noise_trials = 1e5},
      DecisionRule::differencing);
  EXPECT_NEAR(found->dprime, kDprime, 0.02);
}

TEST(DecisionRules, SameDifferentByClassesIsWhatSuchAnObserverDoes) {
  constexpr double kDprime = 1.4;
  const auto classes_differ = [](double distance) {
    return [distance](Random& random) {
      const bool first = random.normal() > 0.5 * kDprime;
      return first != (random.normal() + distance > 0.5 * kDprime);
    };
  };
  const auto found =
      same_different_sensitivity({.hit = simulated(kSimulatedTrials, classes_differ(kDprime)),
                                  .false_alarm = simulated(kSimulatedTrials, classes_differ(0.0)),
                                  .signal_trials = 1e5,
                                  .noise_trials = 1e5},
                                 DecisionRule::independent);
  EXPECT_NEAR(found->dprime, kDprime, 0.02);
}

TEST(DecisionRules, HitRateAndSensitivityAreInverse) {
  for (const DecisionRule rule : {DecisionRule::independent, DecisionRule::differencing}) {
    for (const double dprime : {0.5, 1.0, 3.0}) {
      const DetectionRates rates{.hit = same_different_hit_rate(dprime, 0.2, rule),
                                 .false_alarm = 0.2,
                                 .signal_trials = 60.0,
                                 .noise_trials = 60.0};
      const auto found = same_different_sensitivity(rates, rule);
      ASSERT_TRUE(found);
      EXPECT_NEAR(found->dprime, dprime, 1e-8);
      EXPECT_TRUE(found->standard_error);
    }
  }
}

// The standard error of d′ is the change of d′ with a change of each rate by its standard error, added as squares.
TEST(DecisionRules, StandardErrorsFollowTheDerivatives) {
  const DetectionRates at{
      .hit = 0.7, .false_alarm = 0.25, .signal_trials = 60.0, .noise_trials = 80.0};
  struct OfRates {
    std::optional<RuleSensitivity> (*find)(const DetectionRates&, DecisionRule);
  };
  for (const OfRates of : {OfRates{same_different_sensitivity}, OfRates{abx_sensitivity}}) {
    for (const DecisionRule rule : {DecisionRule::independent, DecisionRule::differencing}) {
      const auto changed = [&](double hit, double false_alarm) {
        DetectionRates rates = at;
        rates.hit += hit;
        rates.false_alarm += false_alarm;
        return of.find(rates, rule)->dprime;
      };
      constexpr double kStep = 1e-5;
      const double by_hit = (changed(kStep, 0.0) - changed(-kStep, 0.0)) / (2.0 * kStep);
      const double by_false = (changed(0.0, kStep) - changed(0.0, -kStep)) / (2.0 * kStep);
      const double variance =
          by_hit * by_hit * 0.7 * 0.3 / 60.0 + by_false * by_false * 0.25 * 0.75 / 80.0;
      EXPECT_NEAR(*of.find(at, rule)->standard_error, std::sqrt(variance), 1e-4);
    }
  }
}

TEST(DecisionRules, OddityIsWhatObserversOfBothRulesDo) {
  constexpr double kDprime = 2.0;
  const auto chooses_odd = [](const auto& conspicuousness) {
    return [&conspicuousness](Random& random) {
      const double odd = random.normal() + 0.5 * kDprime;
      const double one = random.normal() - 0.5 * kDprime;
      const double other = random.normal() - 0.5 * kDprime;
      const double of_odd = conspicuousness(odd, one, other);
      return of_odd > conspicuousness(one, odd, other) && of_odd > conspicuousness(other, odd, one);
    };
  };
  const auto distance_from_mean = [](double own, double one, double other) {
    return std::abs(own - (own + one + other) / 3.0);
  };
  // The likelihood that this one is odd, of either kind: the midpoint of both kinds is 0.
  const auto likelihood = [](double own, double one, double other) {
    return std::cosh(kDprime * 0.5 * (own - one - other));
  };
  EXPECT_NEAR(Oddity{.rule = DecisionRule::differencing}.proportion(kDprime),
              simulated(kSimulatedTrials, chooses_odd(distance_from_mean)), kSimulatedReach);
  EXPECT_NEAR(Oddity{.rule = DecisionRule::independent}.proportion(kDprime),
              simulated(kSimulatedTrials, chooses_odd(likelihood)), kSimulatedReach);
}

TEST(DecisionRules, OddityBeginsAtAThirdAndIsInvertedByTheSensitivity) {
  for (const DecisionRule rule : {DecisionRule::independent, DecisionRule::differencing}) {
    const Oddity oddity{.rule = rule};
    EXPECT_NEAR(oddity.proportion(0.0), 1.0 / 3.0, 1e-12);
    EXPECT_DOUBLE_EQ(oddity.proportion(-1.5), oddity.proportion(1.5));
    for (const double dprime : {0.4, 1.0, 3.5}) {
      EXPECT_NEAR(oddity.dprime(oddity.proportion(dprime)), dprime, 1e-7);
    }
    EXPECT_EQ(oddity.dprime(0.2), 0.0);
    EXPECT_TRUE(std::isinf(oddity.dprime(1.0)));
    EXPECT_THROW(oddity.dprime(1.2), std::invalid_argument);
  }
}

// The ideal observer of a task is at least as good as one who uses only differences.
TEST(DecisionRules, IndependentObservationsAreBetterThanDifferences) {
  for (const double dprime : {0.5, 1.0, 2.0, 4.0}) {
    EXPECT_GT(Oddity{.rule = DecisionRule::independent}.proportion(dprime),
              Oddity{.rule = DecisionRule::differencing}.proportion(dprime));
  }
}

}  // namespace
}  // namespace asperity
